package rasterlab.tests.window;

import java.awt.AWTEvent;
import java.awt.Dialog;
import java.awt.Toolkit;
import java.awt.event.WindowEvent;
import rasterlab.app.cli.Lab;
import rasterlab.app.shell.LabFrame;
import rasterlab.app.shell.WindowStart;
import rasterlab.tests.bench.window.WindowContent;

/**
 * The lab as its command starts it; says what opens: the tab that is shown and its language, a
 * dialog's title.
 */
final class StartedWindow {
    private StartedWindow() {}

    public static void main(String[] arguments) {
        Toolkit.getDefaultToolkit()
                .addAWTEventListener(StartedWindow::say, AWTEvent.WINDOW_EVENT_MASK);
        WindowStart.open(Lab.windowIn(arguments), Lab.notices());
    }

    private static void say(AWTEvent event) {
        if (event.getID() != WindowEvent.WINDOW_OPENED) return;
        if (event.getSource() instanceof LabFrame frame)
            System.out.println(WindowContent.of(frame).shown() + " " + frame.language());
        else if (event.getSource() instanceof Dialog dialog) System.out.println(dialog.getTitle());
    }
}
