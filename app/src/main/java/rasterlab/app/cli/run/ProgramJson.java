package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.app.language.Complaints;
import rasterlab.exercises.json.JsonSink;

/** Writes values as JSON, with the engine's sentences as a program is told them. */
public final class ProgramJson extends JsonSink {
    public ProgramJson(JsonGenerator json) {
        super(json);
    }

    @Override
    public void sentence(String name, String english) throws IOException {
        text(name, Complaints.saidToProgram(english));
    }
}
