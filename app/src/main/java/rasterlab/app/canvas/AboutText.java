package rasterlab.app.canvas;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import javax.swing.JEditorPane;
import javax.swing.text.DefaultCaret;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Method;

/** A method in a teacher's words: formula, invariant, cost, failures, source. */
public final class AboutText extends JEditorPane {
    private static final long serialVersionUID = 1L;

    private final transient Texts labels;
    private String shown = "";

    public AboutText(String name, Language language) {
        super("text/html", "");
        labels = Texts.of("canvas", language);
        setName(name);
        setEditable(false);
        getAccessibleContext().setAccessibleName(labels.text("about"));
        setOpaque(false);
        // A new text is not to scroll the inspector.
        if (getCaret() instanceof DefaultCaret caret)
            caret.setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        setBorder(null);
        putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
    }

    /**
     * @param translations texts {@code METHOD.formula} and so on, where there are any
     * @param decision what the decision variable is; "" for a method without one
     * @param refusal what the method said to the present input; "" when it drew
     */
    public void show(Texts translations, Method<?> method, String decision, String refusal) {
        show(translations, method.name(), method, decision, refusal);
    }

    /**
     * @param key what the texts' keys begin with, where methods of two topics have one name
     */
    public void show(
            Texts translations, String key, Method<?> method, String decision, String refusal) {
        show(paragraphs(parts("", translations, key, method, decision, refusal)));
    }

    /**
     * A method that no chooser beside the text names.
     *
     * @param name what it is called there
     * @param translations texts {@code KEY.formula} and so on, where there are any
     */
    public record Called(String name, Texts translations, String key, Method<?> method) {}

    /** Several methods, each by its name first. */
    public void show(List<Called> methods) {
        show(
                methods.stream()
                        .map(
                                one ->
                                        parts(
                                                one.name(),
                                                one.translations(),
                                                one.key(),
                                                one.method(),
                                                "",
                                                ""))
                        .map(this::paragraphs)
                        .collect(Collectors.joining("<p style='margin: 0 0 5 0'>&nbsp;</p>")));
    }

    private static Map<String, String> parts(
            String name,
            Texts translations,
            String key,
            Method<?> method,
            String decision,
            String refusal) {
        Method.About about = method.about();
        var parts = new LinkedHashMap<String, String>();
        parts.put("method", name);
        parts.put("refusal", refusal);
        parts.put("formula", translated(translations, key, "formula", about.formula()));
        parts.put("decision", decision);
        parts.put("invariant", translated(translations, key, "invariant", about.invariant()));
        parts.put("cost", translated(translations, key, "cost", about.cost()));
        parts.put("failures", translated(translations, key, "failures", about.failures()));
        parts.put("source", translated(translations, key, "source", about.source()));
        return parts;
    }

    /**
     * What is no method of a topic.
     *
     * @param texts {@code about.formula} and so on, for each part
     */
    public void show(Texts texts) {
        var parts = new LinkedHashMap<String, String>();
        for (String part : List.of("formula", "invariant", "cost", "failures", "source"))
            parts.put(part, texts.text("about." + part));
        show(paragraphs(parts));
    }

    /** Shows a text unless it is shown already, so that a selection in it stays. */
    private void show(String paragraphs) {
        String html = "<html><body>" + paragraphs + "</body></html>";
        if (html.equals(shown)) return;
        shown = html;
        setText(html);
        setCaretPosition(0);
    }

    private static String translated(Texts translations, String key, String part, String english) {
        return translations.textOr(key + "." + part, english);
    }

    private String paragraphs(Map<String, String> parts) {
        var html = new StringBuilder();
        parts.forEach(
                (part, text) -> {
                    if (!text.isEmpty())
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
