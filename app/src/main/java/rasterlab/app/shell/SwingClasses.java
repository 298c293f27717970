package rasterlab.app.shell;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.text.BreakIterator;
import java.text.NumberFormat;
import java.util.List;
import java.util.Locale;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JEditorPane;
import javax.swing.JFormattedTextField;
import javax.swing.JFrame;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JSeparator;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTabbedPane;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import javax.swing.text.NumberFormatter;
import javax.swing.text.html.InlineView;
import javax.swing.text.html.ParagraphView;
import net.miginfocom.swing.MigLayout;

/**
 * What a first panel needs of Java that other threads than that of the events may do: loading the
 * classes of components without making one, text, a layout, a picture. Their first use takes most
 * of the time of the panel's parts; while {@link FirstComponents} are used, this does the rest.
 */
final class SwingClasses {
    private static final List<Class<?>> OF_PANELS =
            List.of(
                    DefaultListCellRenderer.class,
                    JCheckBox.class,
                    JComboBox.class,
                    InlineView.class,
                    JButton.class,
                    JEditorPane.class,
                    JFormattedTextField.class,
                    JFrame.class,
                    JPopupMenu.class,
                    JScrollPane.class,
                    JSeparator.class,
                    JSlider.class,
                    JSpinner.NumberEditor.class,
                    JTabbedPane.class,
                    JTextArea.class,
                    NumberFormatter.class,
                    ParagraphView.class);

    private SwingClasses() {}

    /** Loads them for the look that is installed, and numbers of that language. */
    static void load(Locale language) {
        OF_PANELS.forEach(SwingClasses::load);
        for (Object key : UIManager.getLookAndFeelDefaults().keySet().toArray())
            if (key.toString().endsWith("UI")) UIManager.getDefaults().getUIClass(key.toString());
        new MigLayout("insets 0, gap 6", "[grow,fill]8[]", "[center]");
        NumberFormat.getInstance(language).format(0.5);
        BreakIterator.getLineInstance(language).setText("a b");
        draw();
    }

    private static void load(Class<?> type) {
        try {
            Class.forName(type.getName(), true, type.getClassLoader());
        } catch (ClassNotFoundException e) {
            throw new AssertionError(type + " names itself wrongly", e);
        }
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
