package rasterlab.tests.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.StandardOpenOption;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;
import org.junit.platform.launcher.listeners.SummaryGeneratingListener;

@Tag("slow")
class OwnDisplayTest {
    @Test
    void classHasItsDisplayWhileItRunsAndNoLonger() throws IOException {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        var listener = new SummaryGeneratingListener();
        LauncherFactory.create()
                .execute(
                        LauncherDiscoveryRequestBuilder.request()
                                .selectors(selectClass(Opening.class))
                                .build(),
                        listener);
        assertEquals(1, listener.getSummary().getTestsSucceededCount(), "not its own");
        assertFalse(isOurs(), "kept after the class");
    }

    /** Run by the test above alone. */
    @ExtendWith(OwnDisplay.class)
    static class Opening {
        @Test
        void hasItsTurn() throws IOException {
            assertTrue(isOurs());
        }
    }

    /** Java refuses a lock that its own process has already; on POSIX systems asking lets it go. */
    private static boolean isOurs() throws IOException {
        try (var channel =
                FileChannel.open(
                        OwnDisplay.file(), StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
            channel.tryLock();
            return false;
        } catch (OverlappingFileLockException ours) {
            return true;
        }
    }
}
