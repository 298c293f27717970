package rasterlab.app.shell;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.text.BreakIterator;
import java.text.NumberFormat;
import java.util.Locale;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;

/**
 * Loads the classes of Java that a first panel needs, on a thread other than that of the events:
 * those that draw components, text, a layout, a picture. Their first use takes much of the time of
 * the panel's parts.
 */
final class SwingClasses {
    private SwingClasses() {}

    /** Loads them for the look that is installed, and numbers of that language. */
    static void load(Locale language) {
        for (Object key : UIManager.getLookAndFeelDefaults().keySet().toArray())
            if (key.toString().endsWith("UI")) UIManager.getDefaults().getUIClass(key.toString());
        new MigLayout("insets 0, gap 6", "[grow,fill]8[]", "[center]");
        NumberFormat.getInstance(language).format(0.5);
        BreakIterator.getLineInstance(language).setText("a b");
        draw();
    }

    private static void draw() {
        var picture = new BufferedImage(32, 32, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        graphics.setRenderingHint(
                RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        Font font = UIManager.getFont("defaultFont");
        graphics.setFont(font);
        graphics.drawString("a", 0, graphics.getFontMetrics().stringWidth("b"));
        graphics.setFont(font.deriveFont(Font.BOLD));
        graphics.drawString("a", 0, graphics.getFontMetrics().stringWidth("b"));
        graphics.setColor(Color.GRAY);
        graphics.draw(new Ellipse2D.Double(1, 1, 9, 9));
        graphics.dispose();
    }
}
