package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.fail;

import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;

/**
 * Fails a class of tests that leaves behind what all classes of its process share, and gives it
 * back: otherwise another class fails, in some orders only.
 *
 * <p>JUnit finds it for every class of this module.
 */
public final class Leftovers implements BeforeAllCallback, AfterAllCallback {
    private static final Namespace NAMESPACE = Namespace.create(Leftovers.class);

    @Override
    public void beforeAll(ExtensionContext context) throws InterruptedException {
        if (isPart(context)) return;
        OffscreenPainter.onEventThread(
                () -> {
                    UsualLook.restore();
                    context.getStore(NAMESPACE).put(Shared.class, Shared.now());
                });
    }

    @Override
    public void afterAll(ExtensionContext context) throws InterruptedException {
        if (isPart(context)) return;
        Shared before = context.getStore(NAMESPACE).get(Shared.class, Shared.class);
        var left = new ArrayList<String>();
        OffscreenPainter.onEventThread(
                () -> {
                    before.giveBack(left);
                    UsualLook.restore().ifPresent(left::add);
                });
        if (!left.isEmpty())
            fail(context.getDisplayName() + " leaves behind\n" + String.join("\n", left));
    }

    /** Whether the class stands in another one, which gives back what both installed. */
    private static boolean isPart(ExtensionContext context) {
        return context.getParent().flatMap(ExtensionContext::getTestClass).isPresent();
    }

    /** The objects that are shared beside the look. */
    record Shared(
            Locale locale,
            Thread.UncaughtExceptionHandler handler,
            KeyboardFocusManager keyboard,
            List<Window> windows) {
        static Shared now() {
            return new Shared(
                    Locale.getDefault(),
                    Thread.getDefaultUncaughtExceptionHandler(),
                    KeyboardFocusManager.getCurrentKeyboardFocusManager(),
                    Stream.of(Window.getWindows()).filter(Window::isShowing).toList());
        }

        /**
         * @param left what is not as it was is added
         */
        void giveBack(List<String> left) {
            Shared now = now();
            if (!now.locale.equals(locale)) {
                left.add("locale: " + now.locale);
                Locale.setDefault(locale);
            }
            if (now.handler != handler) {
                left.add("handler of failures: " + now.handler);
                Thread.setDefaultUncaughtExceptionHandler(handler);
            }
            if (now.keyboard != keyboard) {
                left.add("keyboard: " + now.keyboard);
                KeyboardFocusManager.setCurrentKeyboardFocusManager(keyboard);
            }
            for (Window window : now.windows) {
                if (windows.contains(window)) continue;
                left.add("open window: " + window);
                window.dispose();
            }
        }
    }
}
