package rasterlab.app.clip;

import java.util.Locale;
import javax.swing.JEditorPane;
import org.joml.Matrix4d;
import org.joml.Vector4d;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Texts;
import rasterlab.engine.transform.ProjectionMatrices;

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

    void show(VolumeScene scene) {
        var html = new StringBuilder("<html><body>");
        Matrix4d normalize = scene.screen().normalize();
        Matrix4d canonical = ProjectionMatrices.canonical(scene.zmin());
        matrix(html, texts.text("matrices.normalize"), normalize);
        matrix(html, texts.text("matrices.canonical"), canonical);
        ends(html, scene, normalize, canonical);
        setText(html.append("</body></html>").toString());
        setCaretPosition(0);
    }

    /** The textbook's rows are JOML's columns. */
    private void matrix(StringBuilder html, String title, Matrix4d m) {
        html.append("<p style='margin: 4 0 1 0'><b>").append(title).append("</b></p><table>");
        for (int row = 0; row < 4; row++) {
            html.append("<tr>");
            for (int cell = 0; cell < 4; cell++) cell(html, m.get(row, cell));
            html.append("</tr>");
        }
        html.append("</table>");
    }

    private void ends(
            StringBuilder html, VolumeScene scene, Matrix4d normalize, Matrix4d canonical) {
        SpaceSegment segment = scene.segments().get(0);
        html.append("<p style='margin: 4 0 1 0'><b>")
                .append(texts.text("matrices.ends"))
                .append("</b></p><table>");
        for (int end = 0; end < 2; end++) {
            SpacePoint p = segment.end(end);
            var normalised = new Vector4d(p.x(), p.y(), p.z(), 1);
            Vector4d eye = new Matrix4d(normalize).invert().transform(new Vector4d(normalised));
            Vector4d clip = canonical.transform(new Vector4d(normalised));
            String name = end == 0 ? "A1" : "B1";
            row(html, name + " " + texts.text("matrices.eye"), eye);
            row(html, name + " " + texts.text("matrices.normalised"), normalised);
            row(html, name + " · M<sub>p</sub>", clip);
            row(html, name + " ÷ H", new Vector4d(clip).div(clip.w));
        }
        html.append("</table>");
    }

    private void row(StringBuilder html, String name, Vector4d p) {
        html.append("<tr><td>").append(name).append("</td>");
        for (int i = 0; i < 4; i++) cell(html, p.get(i));
        html.append("</tr>");
    }

    private void cell(StringBuilder html, double value) {
        Locale locale = texts.locale();
        html.append("<td align=right>&nbsp;")
                .append(Shown.number(value, DECIMALS, locale))
                .append("</td>");
    }
}
