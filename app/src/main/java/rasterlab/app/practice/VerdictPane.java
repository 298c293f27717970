package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.Color;
import java.awt.Font;
import java.util.List;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Predicting.PredictedField;
import rasterlab.exercises.predicting.StepText;

/** Says whether the last answer was right, what is right, and why. */
final class VerdictPane extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;
    private final JLabel verdict = new JLabel(" ");
    private final WrappedText why = new WrappedText("practice.why");

    VerdictPane(Texts texts) {
        super(new MigLayout("insets 0, gap 0 4, wrap 1, hidemode 3", "[grow,fill]", ""));
        this.texts = texts;
        verdict.setName("practice.verdict");
        verdict.setFont(verdict.getFont().deriveFont(Font.BOLD));
        add(verdict, "wmin 0");
        add(why, "wmin 0");
    }

    /** Shows the verdict on an answer, with the method's own reason. */
    void show(AnsweredQuestion last, String topic) {
        Color own = last.right() ? MethodColors.GREEN : MethodColors.VERMILLION;
        verdict.setForeground(MethodColors.textOn(getBackground(), own));
        verdict.setText(texts.text(last.right() ? "right" : "wrong"));
        String language = texts.locale().getLanguage();
        String said = last.question().verdictMessage(last.answer()).in(language);
        Optional<String> line =
                last.question().reason().filter(JsonNode::isTextual).map(JsonNode::asText);
        var words = new StepText(topic, texts.locale());
        if (line.isPresent()) said = said.replace(line.get(), words.word(line.get()));
        List<String> fields =
                last.question().rules().asked().stream().map(PredictedField::field).toList();
        say(sentence(words.named(words.localised(said), fields)));
        setVisible(true);
    }

    private static String sentence(String words) {
        String whole = words.substring(0, 1).toUpperCase() + words.substring(1);
        return whole.endsWith(".") ? whole : whole + ".";
    }

    /** Asks for what is missing. */
    void tell(String sentence) {
        verdict.setForeground(getForeground());
        verdict.setText(texts.text("incomplete"));
        say(sentence);
        setVisible(true);
    }

    private void say(String words) {
        why.show(words);
        // Screen readers are told of a changed name, so the name holds the whole verdict.
        why.getAccessibleContext().setAccessibleName(verdict.getText() + " " + words);
    }
}
