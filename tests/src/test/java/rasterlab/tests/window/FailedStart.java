package rasterlab.tests.window;

/** A program that fails before its window is there. */
final class FailedStart {
    private FailedStart() {}

    public static void main(String[] arguments) {
        StartedWindow.main(arguments);
        throw new IllegalStateException("no window is there yet");
    }
}
