package rasterlab.app.canvas.work;

/** A component whose picture is made in the background. */
public interface Settling {
    /**
     * Waits until the picture belongs to the present size and settings. Not on the event thread.
     */
    void settle() throws InterruptedException;
}
