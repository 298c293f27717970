package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.app.language.Complaints;

/** Writes values as JSON, with the engine's sentences as a program is told them. */
public final class JsonSink extends rasterlab.exercises.json.JsonSink {
    public JsonSink(JsonGenerator json) {
        super(json);
    }

    @Override
    public void said(String name, String english) throws IOException {
        text(name, Complaints.saidToProgram(english));
    }
}
