package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import rasterlab.exercises.predicting.TypedValue;

/** A text field for each number of a field's value, be that a number, a point or several. */
final class NumbersPart implements AnswerPart {
    private static final int COLUMNS = 6;

    private final JsonNode form;
    private final List<JTextField> fields = new ArrayList<>();
    private final JPanel row = new JPanel(new MigLayout("insets 0, gap 6, wrap 3", "", ""));

    /**
     * @param form a value with as many numbers
     * @param name what a screen reader calls the field
     * @param confirmed runs at Enter
     */
    NumbersPart(String field, JsonNode form, String name, Runnable confirmed) {
        this.form = form;
        int count = TypedValue.count(form);
        for (int i = 0; i < count; i++) {
            var text = new JTextField(COLUMNS);
            text.setName("practice." + field + (count == 1 ? "" : "." + i));
            text.getAccessibleContext().setAccessibleName(count == 1 ? name : name + " " + (i + 1));
            text.addActionListener(e -> confirmed.run());
            fields.add(text);
            row.add(text);
        }
    }

    @Override
    public Optional<JsonNode> value() {
        var numbers = new ArrayList<JsonNode>();
        for (JTextField field : fields) TypedValue.number(field.getText()).ifPresent(numbers::add);
        return numbers.size() < fields.size()
                ? Optional.empty()
                : Optional.of(TypedValue.formed(form, numbers.iterator()));
    }

    @Override
    public void set(JsonNode value) {
        List<String> numbers = TypedValue.numbers(value);
        if (numbers.size() != fields.size()) return;
        for (int i = 0; i < numbers.size(); i++) fields.get(i).setText(numbers.get(i));
    }

    @Override
    public JComponent component() {
        return row;
    }

    @Override
    public void focus() {
        fields.stream()
                .filter(field -> TypedValue.number(field.getText()).isEmpty())
                .findFirst()
                .orElse(fields.get(0))
                .requestFocusInWindow();
    }

    @Override
    public boolean digit(int digit) {
        return false;
    }
}
