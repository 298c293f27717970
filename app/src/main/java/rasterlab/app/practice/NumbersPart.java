package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DecimalNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;

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
        int count = count(form);
        for (int i = 0; i < count; i++) {
            var text = new JTextField(COLUMNS);
            text.setName("practice." + field + (count == 1 ? "" : "." + i));
            text.getAccessibleContext().setAccessibleName(count == 1 ? name : name + " " + (i + 1));
            text.addActionListener(e -> confirmed.run());
            fields.add(text);
            row.add(text);
        }
    }

    /** Whether the value is a number, or has nothing but numbers in its rows. */
    static boolean fits(JsonNode value) {
        if (!value.isArray()) return value.isNumber();
        for (JsonNode one : value) if (!fits(one)) return false;
        return true;
    }

    private static int count(JsonNode value) {
        if (!value.isArray()) return 1;
        int count = 0;
        for (JsonNode one : value) count += count(one);
        return count;
    }

    @Override
    public Optional<JsonNode> value() {
        var numbers = new ArrayList<JsonNode>();
        for (JTextField field : fields) number(field.getText()).ifPresent(numbers::add);
        return numbers.size() < fields.size()
                ? Optional.empty()
                : Optional.of(formed(form, numbers.iterator()));
    }

    private static JsonNode formed(JsonNode form, Iterator<JsonNode> numbers) {
        if (!form.isArray()) return numbers.next();
        ArrayNode row = JsonNodeFactory.instance.arrayNode();
        for (JsonNode one : form) row.add(formed(one, numbers));
        return row;
    }

    /** A number with a point or a comma, and any minus; empty where it is none. */
    static Optional<JsonNode> number(String text) {
        String plain = text.strip().replace('−', '-').replace(',', '.');
        try {
            return Optional.of(DecimalNode.valueOf(new BigDecimal(plain)));
        } catch (NumberFormatException e) {
            return Optional.empty();
        }
    }

    @Override
    public void set(JsonNode value) {
        var numbers = new ArrayList<String>();
        collect(value, numbers);
        if (numbers.size() != fields.size()) return;
        for (int i = 0; i < numbers.size(); i++) fields.get(i).setText(numbers.get(i));
    }

    private static void collect(JsonNode value, List<String> numbers) {
        if (value.isNumber()) numbers.add(value.asText());
        for (JsonNode one : value) collect(one, numbers);
    }

    @Override
    public void clear() {
        fields.forEach(field -> field.setText(""));
    }

    @Override
    public JComponent component() {
        return row;
    }

    @Override
    public void focus() {
        fields.stream()
                .filter(field -> number(field.getText()).isEmpty())
                .findFirst()
                .orElse(fields.get(0))
                .requestFocusInWindow();
    }

    @Override
    public boolean digit(int digit) {
        return false;
    }
}
