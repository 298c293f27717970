package rasterlab.app.canvas;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Texts;

/** Three small buttons in a corner of the stage: nearer, farther, everything; and their keys. */
public final class ZoomButtons extends JPanel {
    private static final long serialVersionUID = 1L;

    /** Zoom factor of one press, or of one notch of the wheel. */
    private static final double FACTOR = 1.25;

    private static final int EDGE = 8;

    private final JComponent stage;
    private final transient Zooming zooming;

    /**
     * @param stage has rulers, and the keyboard where the keys are to work
     */
    public ZoomButtons(Texts texts, JComponent stage, Zooming zooming) {
        super(new MigLayout("insets 0, gap 3"));
        this.stage = stage;
        this.zooming = zooming;
        setOpaque(false);
        add(button("zoom.out", "−", texts, this::farther));
        add(button("zoom.in", "+", texts, this::nearer));
        add(button("zoom.fit", "□", texts, zooming::fit));
        for (String key : List.of("typed +", "typed ="))
            KeyBinding.within(stage, KeyStroke.getKeyStroke(key), this::nearer);
        KeyBinding.within(stage, KeyStroke.getKeyStroke("typed -"), this::farther);
        KeyBinding.within(stage, KeyStroke.getKeyStroke("typed 0"), zooming::fit);
    }

    private void nearer() {
        zooming.zoom(FACTOR, center());
    }

    private void farther() {
        zooming.zoom(1 / FACTOR, center());
    }

    private Point2D center() {
        Rectangle inside = Rulers.inside(stage.getSize());
        return new Point2D.Double(inside.getCenterX(), inside.getCenterY());
    }

    /**
     * @param rotation of the wheel, in notches towards the user
     */
    public static double factor(double rotation) {
        return Math.pow(FACTOR, -rotation);
    }

    /** Puts them into their corner of the stage. */
    public void place() {
        Dimension size = getPreferredSize();
        setBounds(
                stage.getWidth() - size.width - EDGE,
                stage.getHeight() - size.height - EDGE,
                size.width,
                size.height);
    }

    /**
     * Where a handle goes whose point is out of sight: from the buttons to above them.
     *
     * @param point in view units, as the others are
     * @param sight where handles may lie
     */
    public static Rectangle clear(
            Rectangle handle, Point2D point, Rectangle sight, Rectangle buttons) {
        boolean seen = sight.contains(point) && !buttons.contains(point);
        if (seen || !handle.intersects(buttons)) return handle;
        return new Rectangle(handle.x, buttons.y - handle.height, handle.width, handle.height);
    }

    /** Paints on the screen only, in no copied picture. */
    @Override
    public void paint(Graphics g) {
        if (!isPaintingForPrint()) super.paint(g);
    }

    private static JButton button(String key, String sign, Texts texts, Runnable action) {
        var button = new JButton(sign);
        button.setName(key);
        button.setToolTipText(texts.text(key));
        button.getAccessibleContext().setAccessibleName(texts.text(key));
        button.putClientProperty("JButton.squareSize", true);
        button.setFont(button.getFont().deriveFont(PictureType.grown(button.getFont())));
        button.addActionListener(e -> action.run());
        return button;
    }
}
