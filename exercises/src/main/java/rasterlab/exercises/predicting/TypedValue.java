package rasterlab.exercises.predicting;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DecimalNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/** The value of an answer's field in texts that are typed in, one for each of its numbers. */
public final class TypedValue {
    /** A number with as many digits as a double may need, and no more. */
    private static final Pattern NUMBER =
            Pattern.compile("[+-]?(\\d{1,30}\\.?\\d{0,30}|\\.\\d{1,30})([eE][+-]?\\d{1,3})?");

    private TypedValue() {}

    /**
     * How many numbers a value has.
     *
     * @param form a value of the same form
     */
    public static int count(JsonNode form) {
        if (!form.isArray()) return 1;
        int count = 0;
        for (JsonNode one : form) count += count(one);
        return count;
    }

    /** A number with a point or a comma, and any minus; empty where it is none. */
    public static Optional<JsonNode> number(String text) {
        String plain = text.strip().replace('−', '-').replace(',', '.');
        return NUMBER.matcher(plain).matches()
                ? Optional.of(DecimalNode.valueOf(new BigDecimal(plain)))
                : Optional.empty();
    }

    /** The value with these numbers in its rows, of which there are as many as it has. */
    public static JsonNode formed(JsonNode form, Iterator<JsonNode> numbers) {
        if (!form.isArray()) return numbers.next();
        ArrayNode row = JsonNodeFactory.instance.arrayNode();
        for (JsonNode one : form) row.add(formed(one, numbers));
        return row;
    }

    /** The numbers of a value, in order. */
    public static List<String> numbers(JsonNode value) {
        List<String> numbers = new ArrayList<>();
        if (value.isNumber()) numbers.add(value.asText());
        for (JsonNode one : value) numbers.addAll(numbers(one));
        return numbers;
    }
}
