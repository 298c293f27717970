package rasterlab.app.canvas;

import java.awt.Graphics;
import javax.swing.JButton;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Texts;

/** Three small buttons in a corner of the stage: nearer, farther, everything. */
public final class ZoomButtons extends JPanel {
    private static final long serialVersionUID = 1L;

    public ZoomButtons(Texts texts, Runnable nearer, Runnable farther, Runnable everything) {
        super(new MigLayout("insets 0, gap 3"));
        setOpaque(false);
        add(button("zoom.out", "−", texts, farther));
        add(button("zoom.in", "+", texts, nearer));
        add(button("zoom.fit", "□", texts, everything));
    }

    /** They are on the screen only, in no copied picture. */
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
        button.addActionListener(e -> action.run());
        return button;
    }
}
