package rasterlab.app.opengl;

import java.awt.Insets;
import javax.swing.JLabel;

/** A line that is said in fewer words where the whole one has no room. */
final class FittingText extends JLabel {
    private static final long serialVersionUID = 1L;

    private String whole = " ";
    private String brief = " ";

    FittingText(String name) {
        super(" ");
        setName(name);
    }

    void show(String newWhole, String newBrief) {
        whole = newWhole;
        brief = newBrief;
        getAccessibleContext().setAccessibleName(whole);
        fit();
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        fit();
    }

    private void fit() {
        Insets insets = getInsets();
        int room = getWidth() - insets.left - insets.right;
        boolean fits = getWidth() == 0 || getFontMetrics(getFont()).stringWidth(whole) <= room;
        setText(fits ? whole : brief);
        setToolTipText(fits ? null : whole);
    }
}
