package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.engine.polygon.Membership;

/** Which points lie inside, as JSON. */
final class InsideJson {
    private InsideJson() {}

    /** Writes the field {@code inside}: true or false for each point. */
    static void write(JsonGenerator json, Membership inside) throws IOException {
        json.writeArrayFieldStart("inside");
        for (int i = 0; i < inside.size(); i++) json.writeBoolean(inside.inside(i));
        json.writeEndArray();
    }
}
