package rasterlab.exercises.json;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.Shape;
import rasterlab.exercises.CatalogueException;

/** Holds every sentence about a value of a shape, in a file of people and in an input. */
class ShapeSentencesTest {
    private static final Field<Double> SIZE = Field.required("size", Shape.numberAbove(0, 9));
    private static final Field<Integer> COUNT = Field.optional("count", Shape.whole(1, 9));
    private static final Field<int[]> PAIR = Field.required("pair", Shape.wholes(2));

    private static final List<String> VALUES =
            List.of(
                    "null",
                    "false",
                    "0",
                    "-0.0",
                    "2",
                    "7.0",
                    "7.5",
                    "10",
                    "1E400",
                    "12345678901234567890",
                    "\" \"",
                    "\"two\"",
                    "\"three\"",
                    "[]",
                    "[1]",
                    "[1, 2]",
                    "[1.0, 2]",
                    "[1, 2.5]",
                    "[true]",
                    "[1, 2, 3, 4]",
                    "[null, 1, \"x\"]",
                    "[[1, 2]]",
                    "[[1, 2], [3]]",
                    "[[1, 2], [3, {}], [4]]",
                    "[[1, 2], [3, 4], [5, 6], [7, 8]]",
                    "{}",
                    "{\"size\": 1, \"pair\": [1, 2]}",
                    "{\"size\": 1, \"pair\": [1, 2], \"count\": 3}",
                    "{\"pair\": [1]}",
                    "{\"pair\": [1, true], \"size\": 0}",
                    "{\"pair\": [1, true], \"size\": 1, \"size\": 2}",
                    "{\"count\": 0, \"size\": 0}",
                    "{\"count\": 0, \"sise\": 0}",
                    "{\"size\": 10, \"zize\": 0, \"count\": 1.0}",
                    "{\"count\": 1.0, \"size\": 1, \"pair\": [1, 2]}",
                    "[{\"size\": 1, \"pair\": [1, 2]}, {\"pair\": [1, 2.5], \"size\": 1}]",
                    "[{\"size\": 1, \"pair\": [1, 2]}, {\"pair\": [1, 2]}, 3]");

    private static final Map<String, Shape<?>> SHAPES = shapes();

    private static Map<String, Shape<?>> shapes() {
        var shapes = new TreeMap<String, Shape<?>>();
        shapes.put("above", Shape.numberAbove(0, 9));
        shapes.put("flag", Shape.flag());
        shapes.put("from", Shape.number(-2, 9));
        shapes.put("list", Shape.list("flags", Shape.flag(), 1, 2));
        shapes.put("number", Shape.number());
        shapes.put("numbers", Shape.numbers(2, 3));
        shapes.put("nulls", Shape.numbersOrNull(0, 3));
        shapes.put("object", Shape.object(SIZE, COUNT, PAIR));
        shapes.put("objects", Shape.list(Shape.object(SIZE, COUNT, PAIR)));
        shapes.put("points", Shape.points(2, 1, 3));
        shapes.put("text", Shape.text("a name of 1 to 4 letters", 1, 4));
        shapes.put("whole", Shape.whole(0, 9));
        shapes.put("wholes", Shape.wholes(2));
        shapes.put("word", Shape.word(List.of("one", "two")));
        return shapes;
    }

    @Test
    void areSaidAsBeforeInFilesOfPeople() {
        List<String> said = SentencesFile.ofField(SHAPES, VALUES, ShapeSentencesTest::ofFile);
        assertEquals(SentencesFile.read("shapes-in-files.txt", said), said);
    }

    @Test
    void areSaidAsBeforeInInputs() {
        List<String> said = SentencesFile.ofField(SHAPES, VALUES, ShapeSentencesTest::ofInput);
        assertEquals(SentencesFile.read("shapes-in-inputs.txt", said), said);
    }

    private static String ofFile(Shape<?> shape, String json) {
        try {
            return shown(JsonFields.parse("a.json", json, "f").get(Field.required("f", shape)));
        } catch (CatalogueException e) {
            return e.getMessage() + " | " + e.in("ru");
        } catch (InvalidInput e) {
            return e.getMessage();
        }
    }

    private static String ofInput(Shape<?> shape, String json) {
        byte[] text = json.getBytes(StandardCharsets.UTF_8);
        Field<?> field = Field.required("f", shape);
        try {
            return shown(StrictJson.read(text, text.length, List.of(field), false).get(field));
        } catch (InvalidInput e) {
            return e.getMessage();
        }
    }

    private static String shown(Object value) {
        if (value instanceof int[] wholes) return Arrays.toString(wholes);
        if (value instanceof double[] numbers) return Arrays.toString(numbers);
        if (value instanceof Given given) return "size " + given.get(SIZE);
        if (value instanceof List<?> list)
            return list.stream().map(ShapeSentencesTest::shown).toList().toString();
        return "" + value;
    }
}
