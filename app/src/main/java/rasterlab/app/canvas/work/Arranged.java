package rasterlab.app.canvas.work;

/**
 * A choice and how it came into sight: undo brings back both, so that the view stays where the
 * change that is undone left it as it was.
 *
 * @param arrangement another number than that of the picture shown lets a stage show everything
 * @param <C> an immutable choice with {@code equals}
 */
public record Arranged<C>(C choice, int arrangement) {}
