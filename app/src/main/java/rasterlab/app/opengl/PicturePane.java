package rasterlab.app.opengl;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.accessibility.AccessibleRole;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.Wrapping;
import rasterlab.engine.raster.Raster;

/** Shows a finished picture, or says why there is none. */
final class PicturePane extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    /** The margin around words, in view units. */
    private static final int MARGIN = 12;

    /** Points of the smallest type that is read. */
    private static final float LEAST_TYPE = 9;

    private final transient Supplier<Optional<Raster>> picture;
    private final transient Supplier<String> otherwise;
    private final transient Runnable resized;

    /**
     * @param said the name for assistive technology
     * @param otherwise what is said where there is no picture
     * @param resized told when the pane is laid out
     */
    PicturePane(
            String name,
            String said,
            Supplier<Optional<Raster>> picture,
            Supplier<String> otherwise,
            Runnable resized) {
        super(AccessibleRole.CANVAS);
        this.picture = picture;
        this.otherwise = otherwise;
        this.resized = resized;
        setName(name);
        setOpaque(true);
        getAccessibleContext().setAccessibleName(said);
    }

    @Override
    public void doLayout() {
        super.doLayout();
        resized.run();
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(400, 300);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setColor(StageColors.now().margin());
        g.fillRect(0, 0, getWidth(), getHeight());
        Optional<Raster> shown = picture.get();
        if (shown.isPresent())
            g.drawImage(shown.get().image(), 0, 0, getWidth(), getHeight(), null);
        else say(g, otherwise.get());
        if (showsFocus()) focus(g);
        g.dispose();
    }

    /**
     * Draws a sentence in type that is small enough for all of it, but no smaller than can be read.
     */
    private void say(Graphics2D g, String sentence) {
        g.setColor(StageColors.now().ink());
        List<String> lines = lines(g, sentence);
        float least = UIScale.scale(LEAST_TYPE);
        while (lines.size() * g.getFontMetrics().getHeight() > getHeight() - 2 * MARGIN
                && g.getFont().getSize2D() > least) {
            g.setFont(g.getFont().deriveFont(Math.max(least, g.getFont().getSize2D() - 1)));
            lines = lines(g, sentence);
        }
        FontMetrics metrics = g.getFontMetrics();
        int y = MARGIN + metrics.getAscent();
        for (String line : lines) {
            g.drawString(line, MARGIN, y);
            y += metrics.getHeight();
        }
    }

    private List<String> lines(Graphics2D g, String sentence) {
        return Wrapping.lines(sentence, getWidth() - 2 * MARGIN, g.getFontMetrics()::stringWidth);
    }

    /** Frames it in blue between two white lines, so that it is seen on any picture. */
    private void focus(Graphics2D g) {
        g.setColor(Color.WHITE);
        g.setStroke(new BasicStroke(4));
        g.drawRect(2, 2, getWidth() - 4, getHeight() - 4);
        g.setColor(StageColors.LIGHT.focus());
        g.setStroke(new BasicStroke(2));
        g.drawRect(2, 2, getWidth() - 4, getHeight() - 4);
    }
}
