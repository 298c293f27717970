package rasterlab.app.canvas.lab;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.accessibility.AccessibleRole;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.language.Texts;

/**
 * A veil over a stage whose picture is of an earlier input, with a sentence that says what is
 * waited for. The mouse works through it.
 */
final class OldPicture extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    /** How much is seen of the picture, of 255. */
    private static final int VEIL = 150;

    private static final int MARGIN = 12;

    private final String sentence;

    OldPicture(Texts texts) {
        super(AccessibleRole.LABEL);
        sentence = texts.text("awaited");
        setName("awaited");
        setVisible(false);
        getAccessibleContext().setAccessibleName(sentence);
    }

    /** The veil contains no point: whoever points at it points at the stage. */
    @Override
    public boolean contains(int x, int y) {
        return false;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        Color ground = StageColors.now().ground();
        g.setColor(new Color(ground.getRed(), ground.getGreen(), ground.getBlue(), VEIL));
        g.fillRect(0, 0, getWidth(), getHeight());
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setFont(getFont().deriveFont(Font.BOLD));
        FontMetrics metrics = g.getFontMetrics();
        int y = getHeight() / 2;
        Color plate = Plates.nearlyOpaque(StageColors.now().ground());
        for (String line :
                Wrapping.lines(sentence, getWidth() - 2 * MARGIN, metrics::stringWidth)) {
            int x = Math.max(MARGIN, (getWidth() - metrics.stringWidth(line)) / 2);
            Plates.plate(g, line, x, y, plate, StageColors.now().ink());
            y += metrics.getHeight() + 2;
        }
        g.dispose();
    }
}
