package rasterlab.exercises.score;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import javax.imageio.ImageIO;

/**
 * Draws rows of {@code # + - .} as a zoomed pixel grid. Shapes tell as much as colours: right is a
 * filled square, extra a cross, missing an empty ring.
 */
final class GridPicture {
    private static final int CELL = 14;
    private static final Color PAPER = Color.WHITE;
    private static final Color GRID = new Color(0xD8DCE2);
    private static final Color RIGHT = new Color(0x2B3A4A);
    private static final Color EXTRA = new Color(0xC44E00);
    private static final Color MISSING = new Color(0x0063B2);

    private final List<String> rows;

    /**
     * @param rows of equal length, at least one
     */
    GridPicture(List<String> rows) {
        this.rows = rows;
    }

    /** Right, extra and missing pixels, as PNG. */
    byte[] difference() {
        return png("#+-");
    }

    /** Only the pixels whose character is among {@code lit}, as PNG; all drawn as squares. */
    byte[] lit(String lit) {
        List<String> only =
                rows.stream()
                        .map(row -> row.replaceAll("[^" + lit + "]", ".").replaceAll("[+-]", "#"))
                        .toList();
        return new GridPicture(only).png("#");
    }

    private byte[] png(String marks) {
        int width = rows.get(0).length() * CELL + 1;
        int height = rows.size() * CELL + 1;
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(
                RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setColor(PAPER);
        graphics.fillRect(0, 0, width, height);
        graphics.setColor(GRID);
        for (int x = 0; x < width; x += CELL) graphics.drawLine(x, 0, x, height);
        for (int y = 0; y < height; y += CELL) graphics.drawLine(0, y, width, y);
        graphics.setStroke(new BasicStroke(2.5f));
        for (int y = 0; y < rows.size(); y++)
            for (int x = 0; x < rows.get(y).length(); x++)
                if (marks.indexOf(rows.get(y).charAt(x)) >= 0)
                    draw(graphics, rows.get(y).charAt(x), x * CELL, y * CELL);
        graphics.dispose();
        return encoded(image);
    }

    private static void draw(Graphics2D graphics, char mark, int left, int top) {
        int near = 3;
        int far = CELL - 3;
        switch (mark) {
            case '+' -> {
                graphics.setColor(EXTRA);
                graphics.drawLine(left + near, top + near, left + far, top + far);
                graphics.drawLine(left + near, top + far, left + far, top + near);
            }
            case '-' -> {
                graphics.setColor(MISSING);
                graphics.drawOval(left + near, top + near, far - near, far - near);
            }
            default -> {
                graphics.setColor(RIGHT);
                graphics.fillRect(left + 2, top + 2, CELL - 3, CELL - 3);
            }
        }
    }

    private static byte[] encoded(BufferedImage image) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            ImageIO.setUseCache(false);
            if (!ImageIO.write(image, "png", bytes))
                throw new AssertionError("this JDK writes no PNG");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }
}
