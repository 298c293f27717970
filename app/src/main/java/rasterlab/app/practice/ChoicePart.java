package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import rasterlab.app.canvas.lab.Actions;
import rasterlab.app.canvas.widget.FlowRows;

/** Buttons, one for each value that a field may have. */
final class ChoicePart implements AnswerPart {
    private final List<JsonNode> values;
    private final List<String> words;
    private final List<JToggleButton> buttons = new ArrayList<>();
    private final ButtonGroup group = new ButtonGroup();
    private final JPanel row = new JPanel(new FlowRows(6));

    /**
     * @param words what stands on the buttons
     * @param chosen runs when one is pressed
     */
    ChoicePart(String field, List<JsonNode> values, List<String> words, Runnable chosen) {
        this.values = values;
        this.words = words;
        for (int i = 0; i < values.size(); i++) {
            var button = new JToggleButton(words.get(i));
            button.setName("practice." + field + "." + values.get(i).asText());
            button.setMargin(Actions.NARROW);
            button.addActionListener(e -> chosen.run());
            group.add(button);
            buttons.add(button);
            row.add(button);
        }
        FlowRows.keepWrapped(row);
    }

    @Override
    public Optional<JsonNode> value() {
        return IntStream.range(0, buttons.size())
                .filter(i -> buttons.get(i).isSelected())
                .<JsonNode>mapToObj(values::get)
                .findFirst();
    }

    @Override
    public void set(JsonNode value) {
        for (int i = 0; i < buttons.size(); i++)
            if (values.get(i).asText().equals(value.asText())) buttons.get(i).setSelected(true);
    }

    @Override
    public JComponent component() {
        return row;
    }

    @Override
    public void focus() {
        buttons.get(0).requestFocusInWindow();
    }

    /** The button with that digit on it; where buttons have words, the one of that number. */
    @Override
    public boolean digit(int digit) {
        int at = words.indexOf(String.valueOf(digit));
        boolean numbered = words.stream().anyMatch(word -> word.matches("\\d+"));
        if (at < 0 && !numbered) at = digit - 1;
        if (at < 0 || at >= buttons.size()) return false;
        buttons.get(at).doClick();
        return true;
    }
}
