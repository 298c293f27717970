package rasterlab.engine.format;

import java.io.IOException;

/** Some fields of an object. */
@FunctionalInterface
public interface Written {
    /** Writes the fields, each with its name. */
    void write(ValueSink out) throws IOException;
}
