package rasterlab.app.canvas;

import java.awt.Dimension;
import javax.swing.BorderFactory;
import javax.swing.JLabel;

/** Where the mouse points, told in the lower left corner of a stage. */
public final class ReadOut extends JLabel {
    private static final long serialVersionUID = 1L;

    public ReadOut() {
        setName("pointed");
        setOpaque(true);
        setBackground(StageColours.now().ground());
        setForeground(StageColours.now().ink());
        setBorder(BorderFactory.createEmptyBorder(2, 5, 2, 5));
        setVisible(false);
    }

    /** Puts it into its corner of a stage with rulers. */
    public void place(int stageHeight) {
        Dimension size = getPreferredSize();
        setBounds(Rulers.left() + 5, stageHeight - size.height - 6, size.width, size.height);
    }
}
