package rasterlab.exercises.scene;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.json.JsonMistake;

/** A place of a JSON text that knows its path; whatever is wrong there is refused with it. */
final class Place {
    static final JsonMapper MAPPER =
            JsonMapper.builder()
                    .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
                    // Read, so that they are refused with their path.
                    .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
                    .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
                    .build();
    private static final int SHOWN = 60;

    /** The whole text. */
    private final String json;

    private final String path;
    private final JsonNode node;

    private Place(String json, String path, JsonNode node) {
        this.json = json;
        this.path = path;
        this.node = node;
    }

    static Place root(String json) {
        try {
            return new Place(json, "$", MAPPER.readTree(json));
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException("not JSON: " + JsonMistake.in(e), e);
        }
    }

    /** This object, in which only the known fields may occur; none given: any. */
    Place object(String... known) {
        if (!node.isObject()) throw wrong("must be an object {…}, got " + shown());
        for (Iterator<String> names = node.fieldNames(); names.hasNext(); ) {
            String name = names.next();
            if (known.length > 0 && !List.of(known).contains(name))
                throw at(cut(name))
                        .wrong("is not known here; known are " + String.join(", ", known));
        }
        return this;
    }

    /** This place, which holds an object or could have held a scene's name. */
    Place nameOrObject() {
        if (!node.isObject())
            throw wrong("must be a scene's name or an object {…}, got " + shown());
        return this;
    }

    boolean has(String field) {
        return node.has(field);
    }

    boolean isText() {
        return node.isTextual();
    }

    /** A field that must be there. */
    Place at(String field) {
        return new Place(json, path + "." + field, node.path(field));
    }

    Optional<Place> optional(String field) {
        return has(field) ? Optional.of(at(field)) : Optional.empty();
    }

    /** The members of this array. */
    List<Place> members() {
        if (!node.isArray()) throw wrong("must be an array […], got " + shown());
        List<Place> members = new ArrayList<>();
        for (JsonNode member : node)
            members.add(new Place(json, path + "[" + members.size() + "]", member));
        return members;
    }

    String text() {
        if (!node.isTextual() || node.textValue().isBlank())
            throw wrong("must be a text that is not blank, got " + shown());
        return node.textValue();
    }

    boolean flag() {
        if (!node.isBoolean()) throw wrong("must be true or false, got " + shown());
        return node.booleanValue();
    }

    int integer(int least, int most) {
        boolean whole = node.isIntegralNumber() && node.canConvertToInt();
        if (!whole || node.intValue() < least || node.intValue() > most)
            throw wrong("must be " + JsonFields.wholeNumber(least, most) + ", got " + shown());
        return node.intValue();
    }

    double number(double least, double most) {
        double value = node.isNumber() ? node.doubleValue() : Double.NaN;
        if (!(value >= least && value <= most))
            throw wrong("must be a number from %s to %s, got ".formatted(least, most) + shown());
        return value;
    }

    /** So many numbers. */
    double[] numbers(int count, double least, double most) {
        List<Place> members = members();
        if (members.size() != count)
            throw wrong("must have %d numbers, got %d".formatted(count, members.size()));
        return members.stream().mapToDouble(member -> member.number(least, most)).toArray();
    }

    /** This object as it stands, of which all numbers are finite. */
    String json() {
        object();
        requireFinite();
        return node.toString();
    }

    private void requireFinite() {
        if (isEndless()) throw wrong("must be a finite number, got " + shown());
        if (node.isArray()) members().forEach(Place::requireFinite);
        node.fieldNames().forEachRemaining(name -> at(name).requireFinite());
    }

    /** Whether this is NaN or infinite, for which JSON has no number. */
    private boolean isEndless() {
        return node.isFloatingPointNumber() && !Double.isFinite(node.doubleValue());
    }

    /** What {@code make} makes of this place; what it refuses is refused with the path. */
    <T> T made(Function<Place, T> make) {
        try {
            return make.apply(this);
        } catch (WrongPlace e) {
            throw e;
        } catch (IllegalArgumentException e) {
            throw wrong(e.getMessage());
        }
    }

    IllegalArgumentException wrong(String what) {
        return new WrongPlace(path + ": " + what);
    }

    private String shown() {
        if (node.isMissingNode()) return "nothing";
        return cut(isEndless() ? EndlessNumber.at(path, json) : node.toString());
    }

    private static String cut(String text) {
        return text.length() <= SHOWN ? text : text.substring(0, SHOWN) + "…";
    }

    private static final class WrongPlace extends IllegalArgumentException {
        private static final long serialVersionUID = 1;

        WrongPlace(String message) {
            super(message);
        }
    }
}
