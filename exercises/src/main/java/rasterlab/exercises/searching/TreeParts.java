package rasterlab.exercises.searching;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.IntNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;

/** The parts of an input as a tree, each with the place that it may be replaced at. */
final class TreeParts {
    private final List<TreePlace> leaves = new ArrayList<>();
    private final List<ArrayNode> arrays = new ArrayList<>();

    /** Where a value stands: a field of an object, or an item of an array. */
    record TreePlace(JsonNode parent, String field, int index) {
        JsonNode value() {
            return parent instanceof ObjectNode ? parent.get(field) : parent.get(index);
        }

        void put(JsonNode value) {
            if (parent instanceof ObjectNode object) object.set(field, value);
            else ((ArrayNode) parent).set(index, value);
        }
    }

    TreeParts(JsonNode tree) {
        add(tree);
    }

    private void add(JsonNode node) {
        if (node instanceof ObjectNode object)
            for (String field : fields(object)) part(new TreePlace(object, field, 0));
        if (node instanceof ArrayNode array) {
            arrays.add(array);
            for (int i = 0; i < array.size(); i++) part(new TreePlace(array, "", i));
        }
    }

    private static List<String> fields(ObjectNode object) {
        var names = new ArrayList<String>();
        object.fieldNames().forEachRemaining(names::add);
        return names;
    }

    private void part(TreePlace place) {
        if (place.value().isContainerNode()) add(place.value());
        else leaves.add(place);
    }

    /** Numbers, words and flags, in the order in which they are written. */
    List<TreePlace> leaves() {
        return leaves;
    }

    /** The numbers alone. */
    List<TreePlace> numbers() {
        return leaves.stream().filter(place -> place.value().isNumber()).toList();
    }

    /** Arrays, outer ones first. */
    List<ArrayNode> arrays() {
        return arrays;
    }

    /** The number as it is written: one that is whole and small without a point. */
    static JsonNode number(double value) {
        boolean zero = value == 0 && 1 / value < 0;
        return value == Math.rint(value) && Math.abs(value) <= Integer.MAX_VALUE && !zero
                ? IntNode.valueOf((int) value)
                : DoubleNode.valueOf(value);
    }
}
