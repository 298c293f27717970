package rasterlab.app.cli.study;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;

/**
 * A value that differs from a right one in one place.
 *
 * @param how the place and what was done there
 */
public record Spoilt(String how, JsonNode value) {
    private static final List<String> OTHERS =
            List.of("\"1\"", "null", "true", "{}", "[]", "-1", "0.5", "3e9", "1e300", "-1e300");

    /** The value spoilt in each of its places in turn; of a long array in the first and last. */
    public static List<Spoilt> all(JsonNode right) {
        var all = new ArrayList<Spoilt>();
        for (String other : OTHERS) all.add(new Spoilt("is " + other, TopicSchemas.tree(other)));
        if (right instanceof ObjectNode object) addAll(object, all);
        if (right instanceof ArrayNode array) addAll(array, all);
        return all;
    }

    private static void addAll(ObjectNode object, List<Spoilt> all) {
        all.add(new Spoilt("/surplus is added", object.deepCopy().put("surplus", 1)));
        for (var field : object.properties()) {
            String name = field.getKey();
            all.add(new Spoilt("/" + name + " is missing", object.deepCopy().without(name)));
            for (Spoilt part : all(field.getValue()))
                all.add(part.in(name, object.deepCopy().set(name, part.value)));
        }
    }

    private static void addAll(ArrayNode array, List<Spoilt> all) {
        if (array.isEmpty()) return;
        int last = array.size() - 1;
        ArrayNode shorter = array.deepCopy();
        shorter.remove(last);
        all.add(new Spoilt("/" + last + " is missing", shorter));
        all.add(new Spoilt("/" + last + " is there twice", array.deepCopy().add(array.get(last))));
        for (int i : last == 0 ? new int[] {0} : new int[] {0, last})
            for (Spoilt part : all(array.get(i)))
                all.add(part.in(String.valueOf(i), array.deepCopy().set(i, part.value)));
    }

    private Spoilt in(String name, JsonNode whole) {
        return new Spoilt("/" + name + (how.startsWith("/") ? "" : " ") + how, whole);
    }
}
