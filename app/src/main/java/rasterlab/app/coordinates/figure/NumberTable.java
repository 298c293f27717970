package rasterlab.app.coordinates.figure;

import java.util.List;
import javax.swing.JEditorPane;
import javax.swing.UIManager;
import javax.swing.text.DefaultCaret;
import javax.swing.text.View;

/**
 * Rows of numbers under their headings, which can be selected and copied; in smaller type where the
 * column is too narrow for them.
 */
public final class NumberTable extends JEditorPane {
    private static final long serialVersionUID = 1L;

    private static final float SMALLEST = 0.6f;

    /** The step by which the type gets smaller or larger, in points. */
    private static final float STEP = 0.5f;

    private String shown = "";

    /**
     * @param said its name for assistive technology
     */
    public NumberTable(String name, String said) {
        super("text/html", "");
        setName(name);
        setEditable(false);
        setOpaque(false);
        setBorder(null);
        getAccessibleContext().setAccessibleName(said);
        putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
        if (getCaret() instanceof DefaultCaret caret)
            caret.setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
    }

    /**
     * @param rows cells as they are written
     * @param marked number of the row in bold, −1 for none
     */
    public void show(List<String> headings, List<List<String>> rows, int marked) {
        var html = new StringBuilder("<html><body><table cellspacing=0 cellpadding=1><tr>");
        for (String heading : headings)
            html.append("<td align=right nowrap><b>&nbsp;&nbsp;")
                    .append(heading)
                    .append("</b></td>");
        html.append("</tr>");
        for (int i = 0; i < rows.size(); i++) {
            html.append("<tr>");
            for (String cell : rows.get(i))
                html.append("<td align=right nowrap>&nbsp;&nbsp;")
                        .append(i == marked ? "<b>" + cell + "</b>" : cell)
                        .append("</td>");
            html.append("</tr>");
        }
        String text = html.append("</table></body></html>").toString();
        if (text.equals(shown)) return;
        shown = text;
        setText(text);
        setCaretPosition(0);
    }

    @Override
    public void doLayout() {
        super.doLayout();
        fit();
    }

    private void fit() {
        float usual = UIManager.getFont("Label.font").getSize2D();
        float size = getFont().getSize2D();
        while (needed() > getWidth() && size - STEP >= SMALLEST * usual) {
            size -= STEP;
            setFont(getFont().deriveFont(size));
        }
        while (size < usual && needed() * (size + 2 * STEP) / size <= getWidth()) {
            size = Math.min(usual, size + STEP);
            setFont(getFont().deriveFont(size));
        }
    }

    /** Width of the rows, in view units. */
    float needed() {
        return getUI().getRootView(this).getMinimumSpan(View.X_AXIS);
    }
}
