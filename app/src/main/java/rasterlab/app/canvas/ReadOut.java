package rasterlab.app.canvas;

import java.awt.Dimension;
import java.awt.FontMetrics;
import javax.swing.BorderFactory;
import javax.swing.JLabel;

/** Where the mouse points, told in the lower left corner of a stage. */
public final class ReadOut extends JLabel {
    private static final long serialVersionUID = 1L;

    /** View units from its text to its upper and its lower edge. */
    private static final int PAD = 2;

    private static final int ABOVE_EDGE = 6;

    public ReadOut() {
        setName("pointed");
        setOpaque(true);
        setBackground(StageColors.now().ground());
        setForeground(StageColors.now().ink());
        setBorder(BorderFactory.createEmptyBorder(PAD, 5, PAD, 5));
        setVisible(false);
    }

    /** How far its upper edge is from the lower edge of a stage, with text in that font. */
    public static int reach(FontMetrics metrics) {
        return metrics.getHeight() + 2 * PAD + ABOVE_EDGE;
    }

    /** Puts it into its corner of a stage with rulers. */
    public void place(int stageHeight) {
        Dimension size = getPreferredSize();
        setBounds(
                Rulers.left() + 5, stageHeight - size.height - ABOVE_EDGE, size.width, size.height);
    }
}
