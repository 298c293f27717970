package rasterlab.exercises.drawing;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.raster.PixelWindow;

/** Draws the pixels of a box as a zoomed grid: those lit as squares, wrong ones as their marks. */
final class GridPicture {
    /** Sides of the picture in its own pixels, so long as its cells keep to the two sizes below. */
    private static final int SIDE = 512;

    private static final int SMALLEST_CELL = 8;
    private static final int LARGEST_CELL = 32;

    private static final Color PAPER = Color.WHITE;
    private static final Color GRID = new Color(0xD8DCE2);
    private static final Color LIT = new Color(0x2B3A4A);

    private final PixelWindow box;
    private final int cell;

    /**
     * @param box at most some hundred pixels wide and high
     */
    GridPicture(PixelWindow box) {
        this.box = box;
        int longest = (int) Math.max(box.width(), box.height());
        cell = Math.max(SMALLEST_CELL, Math.min(LARGEST_CELL, SIDE / longest));
    }

    /**
     * The right, extra and missing pixels as PNG; right ones that are {@code misplaced} crossed
     * out.
     */
    byte[] difference(PixelDifference difference, PixelSet misplaced) {
        return png(
                graphics -> {
                    squares(graphics, difference.right());
                    marks(graphics, PixelMark.EXTRA, misplaced);
                    marks(graphics, PixelMark.MISSING, difference.missing());
                    marks(graphics, PixelMark.EXTRA, difference.extra());
                });
    }

    /** The pixels of both sets, all as squares, as PNG. */
    byte[] lit(PixelSet some, PixelSet others) {
        return png(
                graphics -> {
                    squares(graphics, some);
                    squares(graphics, others);
                });
    }

    private byte[] png(Consumer<Graphics2D> pixels) {
        int width = (int) box.width() * cell + 1;
        int height = (int) box.height() * cell + 1;
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(
                RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setColor(PAPER);
        graphics.fillRect(0, 0, width, height);
        graphics.setColor(GRID);
        for (int x = 0; x < width; x += cell) graphics.drawLine(x, 0, x, height);
        for (int y = 0; y < height; y += cell) graphics.drawLine(0, y, width, y);
        pixels.accept(graphics);
        graphics.dispose();
        return PngBytes.of(image);
    }

    private void squares(Graphics2D graphics, PixelSet pixels) {
        graphics.setColor(LIT);
        each(pixels, (left, top) -> graphics.fillRect(left + 2, top + 2, cell - 3, cell - 3));
    }

    private void marks(Graphics2D graphics, PixelMark mark, PixelSet pixels) {
        each(pixels, (left, top) -> mark.paint(graphics, left, top, cell));
    }

    /** Hands over the upper left corner of the cell of each pixel in the box. */
    private void each(PixelSet pixels, BiConsumer<Integer, Integer> corner) {
        for (int i = 0; i < pixels.size(); i++)
            if (box.contains(pixels.x(i), pixels.y(i)))
                corner.accept((pixels.x(i) - box.xmin()) * cell, (pixels.y(i) - box.ymin()) * cell);
    }
}
