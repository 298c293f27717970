package rasterlab.app.canvas.method;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import javax.swing.JEditorPane;
import javax.swing.text.DefaultCaret;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;

/** A method in a teacher's words: formula, letters, invariant, cost, failures, source. */
public final class AboutText extends JEditorPane {
    private static final long serialVersionUID = 1L;

    /** The parts that are about the present input. */
    private static final Set<String> ANSWERS = Set.of("refusal", "outcome");

    /** The key of what the letters in a topic's formulas stand for. */
    private static final String LETTERS = "letters";

    private final transient Texts labels;
    private String shown = "";
    private transient List<Map<String, String>> newest = List.of();
    private boolean awaited;

    public AboutText(String name, Language language) {
        super("text/html", "");
        labels = Texts.of("canvas", language);
        setName(name);
        setEditable(false);
        getAccessibleContext().setAccessibleName(labels.text("about"));
        setOpaque(false);
        // A new text must not scroll the inspector.
        if (getCaret() instanceof DefaultCaret caret)
            caret.setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        setBorder(null);
        putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
    }

    /**
     * Shows a method, or what is told as one is.
     *
     * @param texts {@code KEY.formula} and so on, for each part
     * @param decision what the decision variable is; "" for a method without one
     * @param refusal what the method said to the present input, or why the user's program gave no
     *     answer; "" when it drew
     */
    public void show(Texts texts, String key, String decision, String refusal) {
        tell(List.of(parts("", texts, key, decision, refusal)));
    }

    /**
     * A method that no chooser beside the text names.
     *
     * @param name what it is called there
     * @param texts {@code KEY.formula} and so on
     */
    public record Called(String name, Texts texts, String key) {}

    /** Shows several methods, each by its name first. */
    public void show(List<Called> methods) {
        tell(
                methods.stream()
                        .map(one -> parts(one.name(), one.texts(), one.key(), "", ""))
                        .toList());
    }

    /** Leaves out what the method said to an earlier input, as long as another is awaited. */
    public void await(boolean another) {
        if (awaited == another) return;
        awaited = another;
        refresh();
    }

    private void tell(List<Map<String, String>> methods) {
        newest = methods;
        refresh();
    }

    private void refresh() {
        show(
                newest.stream()
                        .map(this::paragraphs)
                        .collect(Collectors.joining("<p style='margin: 0 0 5 0'>&nbsp;</p>")));
    }

    private Map<String, String> parts(
            String name, Texts texts, String key, String decision, String refusal) {
        var parts = new LinkedHashMap<String, String>();
        parts.put("method", name);
        boolean own = key.equals(OwnMethods.NAME) || key.endsWith("." + OwnMethods.NAME);
        parts.put(own ? "outcome" : "refusal", refusal);
        if (own) {
            parts.put("decision", decision);
            parts.put("source", labels.text("about.mine"));
            return parts;
        }
        String formula = texts.text(key + ".formula");
        parts.put("formula", formula);
        parts.put("decision", beyond(formula, decision));
        parts.put(LETTERS, "");
        for (String part : List.of("invariant", "cost", "failures", "source"))
            parts.put(part, texts.text(key + "." + part));
        if (texts.has(LETTERS))
            parts.put(
                    LETTERS,
                    LetterLegend.of(
                            texts.text(LETTERS),
                            formula + "; " + decision + "; " + parts.get("invariant")));
        return parts;
    }

    /** Returns those parts of the decision that the formula does not have. */
    private static String beyond(String formula, String decision) {
        return Arrays.stream(decision.split("; "))
                .filter(part -> !formula.contains(part))
                .collect(Collectors.joining("; "));
    }

    /** Shows a text unless it is shown already, so that a selection in it stays. */
    private void show(String paragraphs) {
        String html = "<html><body>" + paragraphs + "</body></html>";
        if (html.equals(shown)) return;
        shown = html;
        setText(html);
        setCaretPosition(0);
    }

    private String paragraphs(Map<String, String> parts) {
        var html = new StringBuilder();
        parts.forEach(
                (part, text) -> {
                    boolean old = awaited && ANSWERS.contains(part);
                    if (!text.isEmpty() && !old)
                        html.append("<p style='margin: 0 0 5 0'><b>")
                                .append(escaped(labels.text("about." + part)))
                                .append(":</b> ")
                                .append(escaped(text))
                                .append("</p>");
                });
        return html.toString();
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
