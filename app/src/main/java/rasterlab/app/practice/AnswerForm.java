package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.BooleanNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Texts;
import rasterlab.app.practice.Board.NamedPick;
import rasterlab.app.practice.Board.Target;
import rasterlab.exercises.Predicting.PredictedField;
import rasterlab.exercises.predicting.Question;
import rasterlab.exercises.predicting.StepText;

/** The controls for an answer: buttons where there is a choice, fields for numbers. */
final class AnswerForm extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;
    private final transient Runnable confirmed;
    private final transient Map<String, AnswerPart> parts = new LinkedHashMap<>();
    private transient StepText names;

    /**
     * @param confirmed runs when the answer is given
     */
    AnswerForm(Texts texts, Runnable confirmed) {
        super(new MigLayout("insets 0, gap 6 8, wrap 2", "[pref!]10[grow,fill]", ""));
        this.texts = texts;
        this.confirmed = confirmed;
    }

    /** Asks for the fields of another question, with nothing in them. */
    void show(String topic, Question question, Optional<Board> board) {
        names = new StepText(topic, texts.locale());
        removeAll();
        parts.clear();
        boolean alone = question.rules().asked().size() == 1;
        for (PredictedField asked : question.rules().asked()) {
            String field = asked.field();
            String name = names.label(field);
            AnswerPart part = part(asked, name, question.right().path(field), board, alone);
            parts.put(field, part);
            var label = new JLabel(name);
            label.setLabelFor(part.component());
            add(label, "aligny top, gaptop 4");
            add(part.component(), "wmin 0");
        }
        revalidate();
        repaint();
    }

    private AnswerPart part(
            PredictedField asked,
            String name,
            JsonNode right,
            Optional<Board> board,
            boolean alone) {
        List<JsonNode> values = choices(asked, right, board);
        if (values.isEmpty()) return new NumbersPart(asked.field(), right, name, confirmed);
        List<String> words = values.stream().map(value -> names.word(value.asText())).toList();
        return new ChoicePart(asked.field(), values, words, alone ? confirmed : () -> {});
    }

    private static List<JsonNode> choices(
            PredictedField asked, JsonNode right, Optional<Board> board) {
        if (!asked.words().isEmpty())
            return asked.words().stream().<JsonNode>map(TextNode::valueOf).toList();
        if (right.isBoolean()) return List.of(BooleanNode.TRUE, BooleanNode.FALSE);
        return board.map(Board::picking)
                .filter(NamedPick.class::isInstance)
                .map(NamedPick.class::cast)
                .filter(named -> named.field().equals(asked.field()))
                .map(named -> named.targets().stream().map(Target::value).toList())
                .orElse(List.of());
    }

    /** The answer so far: an object of the fields that have a value. */
    ObjectNode answer() {
        ObjectNode answer = JsonNodeFactory.instance.objectNode();
        parts.forEach((field, part) -> part.value().ifPresent(value -> answer.set(field, value)));
        return answer;
    }

    /** The field that lacks a value, if one does. */
    Optional<String> missing() {
        return parts.keySet().stream()
                .filter(field -> parts.get(field).value().isEmpty())
                .findFirst();
    }

    /** Shows what was given in the picture. */
    void set(ObjectNode part) {
        part.properties()
                .forEach(
                        one ->
                                Optional.ofNullable(parts.get(one.getKey()))
                                        .ifPresent(control -> control.set(one.getValue())));
    }

    /** Gives the keyboard to the first field that lacks a value. */
    void focus() {
        missing()
                .or(() -> parts.keySet().stream().findFirst())
                .map(parts::get)
                .ifPresent(AnswerPart::focus);
    }

    /** Presses the button that a digit means; false where none does. */
    boolean digit(int digit) {
        return parts.values().stream().anyMatch(part -> part.digit(digit));
    }

    /** Lets answers be given, or not. */
    void showAsking(boolean asking) {
        setVisible(asking);
    }
}
