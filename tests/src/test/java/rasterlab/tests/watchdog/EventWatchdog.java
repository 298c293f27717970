package rasterlab.tests.watchdog;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.GraphicsEnvironment;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;

/**
 * Fails a test during which the event thread was blocked by what {@link Blame} names, and prints at
 * the end of each class which events kept it for more than 50 ms.
 *
 * <p>JUnit finds it for every class of this module; without a display it does nothing.
 */
public final class EventWatchdog implements BeforeAllCallback, AfterEachCallback, AfterAllCallback {
    private static final Namespace NAMESPACE = Namespace.create(EventWatchdog.class);

    @Override
    public void beforeAll(ExtensionContext context) {
        if (GraphicsEnvironment.isHeadless()) return;
        context.getRoot()
                .getStore(NAMESPACE)
                .getOrComputeIfAbsent(Watch.class, type -> Watch.begin(), Watch.class);
    }

    @Override
    public void afterEach(ExtensionContext context) {
        watch(context).ifPresent(EventWatchdog::complain);
    }

    @Override
    public void afterAll(ExtensionContext context) {
        watch(context)
                .ifPresent(
                        watch -> {
                            String name = context.getRequiredTestClass().getSimpleName();
                            String said = LongStays.text(name, watch.takeLongStays());
                            if (!said.isEmpty()) System.out.println(said);
                            complain(watch);
                        });
    }

    /** The watchdog of this run's event thread; empty without a display. */
    static Optional<Watch> watch(ExtensionContext context) {
        return Optional.ofNullable(
                context.getRoot().getStore(NAMESPACE).get(Watch.class, Watch.class));
    }

    private static void complain(Watch watch) {
        List<String> faults = watch.takeFaults();
        assertEquals(0, faults.size(), () -> String.join("\n", faults) + "\n faults");
    }
}
