package rasterlab.app.cli.study;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaLocation;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import rasterlab.app.cli.Ran;

/** The schemas that {@code ./lab methods TOPIC --schema} prints, ready to check values by. */
public record TopicSchemas(JsonNode text, Schema input, Schema output) {
    private static final SchemaRegistry REGISTRY =
            SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12);

    public static TopicSchemas of(String topic) {
        Ran ran = Ran.lab("methods", topic, "--schema");
        ran.assertDone();
        var input = (ObjectNode) tree(ran.out());
        ObjectNode output = input.deepCopy().put("$ref", "#/$defs/output");
        return new TopicSchemas(input, REGISTRY.getSchema(input), REGISTRY.getSchema(output));
    }

    /** The schema of schemas. */
    static Schema ofSchemas() {
        return REGISTRY.getSchema(
                SchemaLocation.of("https://json-schema.org/draft/2020-12/schema"));
    }

    public static JsonNode tree(String json) {
        try {
            return JsonMapper.builder().build().readTree(json);
        } catch (JsonProcessingException e) {
            throw new AssertionError(json, e);
        }
    }
}
