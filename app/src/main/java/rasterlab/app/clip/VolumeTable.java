package rasterlab.app.clip;

import java.util.Arrays;
import java.util.Locale;
import javax.swing.JEditorPane;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Texts;

/**
 * The two normalisations as matrices in the textbook's layout, and a segment's ends through them.
 */
final class VolumeTable extends JEditorPane {
    private static final long serialVersionUID = 1L;

    private static final int DECIMALS = 3;

    private final transient Texts texts;

    VolumeTable(Texts texts) {
        super("text/html", "");
        this.texts = texts;
        setName("matrices");
        setEditable(false);
        setOpaque(false);
        setBorder(null);
        getAccessibleContext().setAccessibleName(texts.text("matrices"));
        putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
    }

    void show(VolumeNumbers numbers) {
        var html = new StringBuilder("<html><body>");
        matrix(html, texts.text("matrices.normalize"), numbers.normalize());
        matrix(html, texts.text("matrices.canonical"), numbers.canonical());
        ends(html, numbers);
        setText(html.append("</body></html>").toString());
        setCaretPosition(0);
    }

    private void matrix(StringBuilder html, String title, double[] rows) {
        title(html, title);
        for (int row = 0; row < 4; row++)
            row(html, "", Arrays.copyOfRange(rows, 4 * row, 4 * row + 4));
        html.append("</table>");
    }

    private void ends(StringBuilder html, VolumeNumbers numbers) {
        title(html, texts.text("matrices.ends"));
        String[] stages = {
            texts.text("matrices.eye"), texts.text("matrices.normalised"), "· M<sub>p</sub>", "÷ H"
        };
        for (int i = 0; i < numbers.ends().size(); i++) {
            String end = i < VolumeNumbers.STAGES ? "A1 " : "B1 ";
            row(html, end + stages[i % VolumeNumbers.STAGES], numbers.ends().get(i));
        }
        html.append("</table>");
    }

    private static void title(StringBuilder html, String title) {
        html.append("<p style='margin: 4 0 1 0'><b>").append(title).append("</b></p><table>");
    }

    private void row(StringBuilder html, String name, double[] numbers) {
        html.append("<tr>");
        if (!name.isEmpty()) html.append("<td>").append(name).append("</td>");
        for (double number : numbers) cell(html, number);
        html.append("</tr>");
    }

    private void cell(StringBuilder html, double value) {
        Locale locale = texts.locale();
        html.append("<td align=right>&nbsp;")
                .append(Shown.number(value, DECIMALS, locale))
                .append("</td>");
    }
}
