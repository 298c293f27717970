package rasterlab.tests.display;

import java.awt.AWTError;
import java.awt.AWTException;
import java.awt.GraphicsEnvironment;
import java.awt.Robot;

/**
 * Ends processes well that end right after they closed a window that showed OpenGL.
 *
 * <p>At the end of the process GLX gives up its part of the connection to the X server, under that
 * connection's lock. AWT's own thread may hold it, stopped by the virtual machine in the middle of
 * what the closed window's last events asked for; then neither ever ends. A window that is closed
 * by hand needs none of this: AWT lets a process end only after a second without events.
 */
public final class DisplayAtRest {
    private DisplayAtRest() {}

    /**
     * Returns when all events that the display had for this process have been handled, at once
     * without a display; never from an event.
     */
    public static void await() {
        if (GraphicsEnvironment.isHeadless()) return;
        try {
            new Robot().waitForIdle();
        } catch (AWTException e) {
            throw (AWTError) new AWTError("cannot wait for the display").initCause(e);
        }
    }
}
