package rasterlab.app.exercise.statement;

import java.awt.Color;
import java.util.Map;
import javax.swing.UIManager;
import javax.swing.text.Element;
import javax.swing.text.StyleConstants;
import javax.swing.text.View;
import javax.swing.text.ViewFactory;
import javax.swing.text.html.HTML;
import javax.swing.text.html.HTMLEditorKit;
import javax.swing.text.html.ParagraphView;
import javax.swing.text.html.StyleSheet;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.exercise.outcome.VerdictLook;
import rasterlab.exercises.formula.Typeset;

/**
 * HTML with a style of its own, since setting one would give it to every label's HTML in the
 * program, and with formulas in type.
 */
final class StatementKit extends HTMLEditorKit {
    private static final long serialVersionUID = 1L;

    private transient StyleSheet own;
    private transient Map<String, Typeset.FormulaOutline> formulas = Map.of();

    /**
     * @param drawn what is shown instead of the text of an element, by its id
     */
    void setFormulas(Map<String, Typeset.FormulaOutline> drawn) {
        formulas = Map.copyOf(drawn);
    }

    @Override
    public ViewFactory getViewFactory() {
        return new HTMLFactory() {
            @Override
            public View create(Element element) {
                Typeset.FormulaOutline formula = formulas.get(TypesetView.id(element));
                if (formula != null) return new TypesetView(element, formula);
                // A line of a program that is too long is wrapped, else all paragraphs are as wide.
                Object kind = element.getAttributes().getAttribute(StyleConstants.NameAttribute);
                if (kind == HTML.Tag.IMPLIED) return new ParagraphView(element);
                return super.create(element);
            }
        };
    }

    @Override
    public StyleSheet getStyleSheet() {
        if (own == null) own = style(super.getStyleSheet());
        return own;
    }

    private static StyleSheet style(StyleSheet usual) {
        var style = new StyleSheet();
        style.addStyleSheet(usual);
        String line = css(UIManager.getColor("Component.borderColor"));
        String code = css(StageColors.now().margin());
        int size = UIManager.getFont("Label.font").getSize();
        style.addRule("body { margin: 0 }");
        style.addRule("h1 { font-size: " + (size + 7) + "pt; margin: 6 0 6 0 }");
        style.addRule("h2 { font-size: " + (size + 2) + "pt; margin: 12 0 4 0 }");
        style.addRule("p { margin: 4 0 6 0 }");
        style.addRule("ul { margin-left: 18; margin-top: 2; margin-bottom: 4 }");
        style.addRule("li { margin: 2 0 2 0 }");
        style.addRule("body { font-size: " + size + "pt }");
        style.addRule(
                "code { font-family: Monospaced; font-size: "
                        + (size - 1)
                        + "pt; background-color: "
                        + code
                        + " }");
        style.addRule(
                "pre { font-family: Monospaced; font-size: "
                        + (size - 2)
                        + "pt; background-color: "
                        + code
                        + "; padding: 6 }");
        style.addRule("td { border: 1px solid " + line + "; vertical-align: top }");
        style.addRule("th { border: 1px solid " + line + "; text-align: left }");
        style.addRule("p.displayed { text-align: center; margin: 6 0 4 0 }");
        style.addRule(
                "i.mistake { color: "
                        + css(VerdictLook.color("wrong", StageColors.now().ground()))
                        + " }");
        return style;
    }

    private static String css(Color color) {
        return "#%06x".formatted(color.getRGB() & 0xFFFFFF);
    }
}
