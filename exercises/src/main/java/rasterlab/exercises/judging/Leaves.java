package rasterlab.exercises.judging;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.document.OwnJson;
import rasterlab.exercises.json.JsonSink;
import rasterlab.exercises.score.Message;

/** The numbers and truth values of an answer, each by its place, such as {@code inside[3]}. */
final class Leaves {
    private static final String NONE = "–";

    private static final Pattern ZERO = Pattern.compile("-?[#0.]+");

    /** A smaller part of the largest difference is passed over, as rounding is. */
    private static final double SEEN = 0.01;

    /** The tolerance in the coordinates of exercises, which are of the order of 1 to 1000. */
    private static final double ROUNDING = 1e-9;

    /** Significant digits that are enough to see most differences. */
    private static final int FEW = 6;

    /** A double has no more. */
    private static final int ALL = 17;

    private final Map<String, String> values = new LinkedHashMap<>();

    static <C, I, O> Leaves of(Format<C, I, O> format, I input, O output) {
        Leaves leaves = new Leaves();
        leaves.add("", tree(format, input, output));
        return leaves;
    }

    /** An output as {@code ./lab run} answers it; what is no number stands by its name. */
    static <C, I, O> JsonNode tree(Format<C, I, O> format, I input, O output) {
        return tree(json -> format.write(input, output, json));
    }

    /** An input as a tree. */
    static <C, I> JsonNode tree(Format<C, I, ?> format, I input) {
        return tree(json -> format.writeInput(input, json));
    }

    /** An input as {@code ./lab run} takes it. */
    static <C, I> String json(Format<C, I, ?> format, I input) {
        return text(json -> format.writeInput(input, json));
    }

    private interface Writing {
        void to(JsonSink json) throws IOException;
    }

    private static JsonNode tree(Writing fields) {
        try {
            return OwnJson.MAPPER.readTree(text(fields));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String text(Writing fields) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = OwnJson.MAPPER.createGenerator(text)) {
            json.writeStartObject();
            fields.to(new AllNumbers(json));
            json.writeEndObject();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return text.toString().replaceAll("(\\d)\\.0(?=[,\\]}])", "$1");
    }

    private void add(String place, JsonNode node) {
        if (node.isArray()) {
            for (int i = 0; i < node.size(); i++) add(place + "[" + i + "]", node.get(i));
            if (node.isEmpty()) values.put(place, NONE);
        } else if (node.isObject()) {
            node.properties()
                    .forEach(
                            field ->
                                    add(
                                            place.isEmpty()
                                                    ? field.getKey()
                                                    : place + "." + field.getKey(),
                                            field.getValue()));
        } else {
            values.put(place, node.isNull() ? NONE : node.asText());
        }
    }

    /** JSON in which what is no number stands by its name. */
    private static final class AllNumbers extends JsonSink {
        private final JsonGenerator json;

        AllNumbers(JsonGenerator json) {
            super(json);
            this.json = json;
        }

        @Override
        public void number(double value) throws IOException {
            if (Double.isFinite(value)) super.number(value);
            else json.writeString(Double.toString(value));
        }
    }

    /** The first part of an answer that differs, and how far all of it is from right. */
    static <C, I, O> Message difference(Topic<C, I, O> topic, I input, O exact, O actual) {
        Leaves right = of(topic.format(), input, exact);
        Leaves mine = of(topic.format(), input, actual);
        Deviation deviation = topic.compare(input, exact, actual);
        if (deviation.extra() > 0 && right.isCloseTo(mine))
            return Message.of("answer.again", deviation.extra());
        Message said =
                right.firstUnlike(mine)
                        .map(place -> right.message(topic.name(), place, mine))
                        .orElse(Message.of("answer.differs"));
        String key = "answer.worst." + topic.errorUnit().replace(' ', '-');
        boolean measured = deviation.worst() > 0 && Double.isFinite(deviation.worst());
        return measured && Message.isKnown(key)
                ? said.and(Message.of(key, number(deviation.worst())))
                : said;
    }

    /**
     * The first part of an answer that differs from what it would be if it fitted the others.
     *
     * @param wanted what it would be then
     */
    static <C, I, O> Message unfit(Topic<C, I, O> topic, I input, O wanted, O actual) {
        Leaves fitting = of(topic.format(), input, wanted);
        Leaves mine = of(topic.format(), input, actual);
        return fitting.firstUnlike(mine)
                .map(
                        place -> {
                            String[] two = distinctTexts(mine.at(place), fitting.at(place));
                            String key = "answer.at.unfit";
                            if (two[0].equals(NONE)) key = "answer.at.unfit-missing";
                            if (two[1].equals(NONE)) key = "answer.at.unfit-extra";
                            return Message.of(key, place, two[0], two[1], topic.name());
                        })
                .orElse(Message.NONE);
    }

    /** Whether there is no number or truth value at all. */
    boolean areNone() {
        return values.values().stream().allMatch(NONE::equals);
    }

    boolean areFalse() {
        return values.values().stream().allMatch("false"::equals);
    }

    /** Whether there is nothing but zeros, as of numbers or of colours. */
    boolean areZeros() {
        return values.values().stream().allMatch(one -> ZERO.matcher(one).matches());
    }

    /** Whether nothing is missing, more or different but for rounding. */
    private boolean isCloseTo(Leaves other) {
        return values.keySet().equals(other.values.keySet())
                && values.keySet().stream().allMatch(place -> apart(place, other) <= ROUNDING);
    }

    /** The first place that differs by what is seen beside the largest difference. */
    Optional<String> firstUnlike(Leaves other) {
        Set<String> places = new LinkedHashSet<>(values.keySet());
        places.addAll(other.values.keySet());
        double largest = places.stream().mapToDouble(place -> apart(place, other)).max().orElse(0);
        return places.stream()
                .filter(place -> !at(place).equals(other.at(place)))
                .filter(place -> apart(place, other) >= SEEN * largest)
                .findFirst();
    }

    /** How far two numbers are apart; 1 for what are no numbers. */
    private double apart(String place, Leaves other) {
        String one = at(place);
        String another = other.at(place);
        if (one.equals(another)) return 0;
        try {
            double apart = Math.abs(Double.parseDouble(one) - Double.parseDouble(another));
            return Double.isFinite(apart) ? apart : 1;
        } catch (NumberFormatException noNumber) {
            return 1;
        }
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Leaves leaves && values.equals(leaves.values);
    }

    @Override
    public int hashCode() {
        return values.hashCode();
    }

    /**
     * Says what another answer has at a place, and what is right there. The topic comes last, so
     * that the place can be put into words.
     */
    private Message message(String topic, String place, Leaves mine) {
        String right = at(place);
        String given = mine.at(place);
        if (right.equals(NONE))
            return Message.of("answer.at.extra", place, shortened(given), topic);
        if (given.equals(NONE))
            return Message.of("answer.at.missing", place, shortened(right), topic);
        String[] two = distinctTexts(given, right);
        return Message.of("answer.at", place, two[0], two[1], topic);
    }

    /** Two values in as many digits as tell them apart. */
    private static String[] distinctTexts(String one, String other) {
        for (int digits = FEW; digits < ALL; digits += 3) {
            String[] two = {rounded(one, digits), rounded(other, digits)};
            if (!two[0].equals(two[1])) return two;
        }
        return new String[] {one, other};
    }

    private static String shortened(String value) {
        return rounded(value, FEW);
    }

    /** A number in so many significant digits; anything else as it is. */
    private static String rounded(String value, int digits) {
        try {
            return number(Double.parseDouble(value), digits);
        } catch (NumberFormatException notANumber) {
            return value;
        }
    }

    private String at(String place) {
        return values.getOrDefault(place, NONE);
    }

    /** The number with at most three significant digits. */
    static String number(double value) {
        return number(value, 3);
    }

    private static String number(double value, int digits) {
        if (value == 0 || !Double.isFinite(value)) return value == 0 ? "0" : "" + value;
        BigDecimal rounded = new BigDecimal(value).round(new MathContext(digits));
        boolean plain = Math.abs(value) >= 1e-4 && Math.abs(value) < 1e9;
        BigDecimal shortest = rounded.stripTrailingZeros();
        return plain ? shortest.toPlainString() : shortest.toString();
    }
}
