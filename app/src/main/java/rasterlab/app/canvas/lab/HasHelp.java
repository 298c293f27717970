package rasterlab.app.canvas.lab;

/** A part of a tab that has help of its own while it is seen. */
public interface HasHelp {
    /** The key of its help; "" where it has none. */
    String helpKey();
}
