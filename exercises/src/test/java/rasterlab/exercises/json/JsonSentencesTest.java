package rasterlab.exercises.json;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Shape;
import rasterlab.exercises.CatalogueException;

/** Holds every sentence about a field of an exercise's data to what authors have read so far. */
class JsonSentencesTest {
    private static final List<String> VALUES =
            List.of(
                    "null",
                    "true",
                    "7",
                    "7.0",
                    "1e2",
                    "1E400",
                    "-3000000000",
                    "\"\"",
                    "\" \"",
                    "\"two\"",
                    "[]",
                    "[1]",
                    "[1, 2]",
                    "[1, \"2\"]",
                    "[1, 2.5]",
                    "[1, 3000000000]",
                    "[\"a\", \"b\"]",
                    "[{}]",
                    "[{\"z\": 1}, 2]",
                    "{}",
                    "{\"z\": 1}",
                    "\"" + "x".repeat(80) + "\"");

    private static final Map<String, Function<JsonFields, Object>> READERS = readers();

    private static Map<String, Function<JsonFields, Object>> readers() {
        var readers = new TreeMap<String, Function<JsonFields, Object>>();
        readers.put("flag", fields -> fields.flag("f", true));
        readers.put("integer", fields -> fields.integer("f", 0, 9));
        readers.put("integer or", fields -> fields.integer("f", 0, 9, 5));
        readers.put(
                "integers",
                fields -> Arrays.toString(fields.get(Field.required("f", Shape.wholes(4)))));
        readers.put("object", fields -> fields.object("f", "a", "b").has("a"));
        readers.put("objects", fields -> fields.objects("f", "a", "b").size());
        readers.put("one", fields -> fields.integer("f", 1, 1));
        readers.put(
                "point",
                fields -> Arrays.toString(fields.get(Field.required("f", Shape.wholes(2)))));
        readers.put("text", fields -> fields.text("f"));
        readers.put("texts", fields -> fields.texts("f"));
        readers.put("word", fields -> fields.word("f", List.of("one", "two")));
        return readers;
    }

    @Test
    void areSaidAsBefore() {
        List<String> said = SentencesFile.ofField(READERS, VALUES, JsonSentencesTest::sentence);
        for (String whole : List.of("7", "[]", "{\"g\": 1}", "[{}, {\"g\": 1}]", "[{}, 7]")) {
            said.add("whole " + whole + ": " + sentence(fields -> "read", whole));
            said.add("array " + whole + ": " + saidOfArray(whole));
        }
        assertEquals(SentencesFile.read("fields.txt", said), said);
    }

    private static String sentence(Function<JsonFields, Object> reader, String json) {
        try {
            return "" + reader.apply(JsonFields.parse("a.json", json, "f"));
        } catch (CatalogueException e) {
            return e.getMessage() + " | " + e.in("ru");
        }
    }

    private static String saidOfArray(String json) {
        try {
            return JsonFields.parseArray("a.json", json, "f").size() + " read";
        } catch (CatalogueException e) {
            return e.getMessage() + " | " + e.in("ru");
        }
    }
}
