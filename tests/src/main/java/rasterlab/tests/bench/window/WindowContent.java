package rasterlab.tests.bench.window;

import rasterlab.app.shell.LabContent;
import rasterlab.app.shell.LabFrame;

/** Finds the tabs of a window, which are made again with each language and look. */
public final class WindowContent {
    private WindowContent() {}

    public static LabContent of(LabFrame frame) {
        return (LabContent) frame.getContentPane().getComponent(0);
    }
}
