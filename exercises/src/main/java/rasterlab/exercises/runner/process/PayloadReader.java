package rasterlab.exercises.runner.process;

import java.io.DataInputStream;
import java.io.IOException;

/** Reads an answer's payload. */
@FunctionalInterface
public interface PayloadReader<T> {
    /**
     * @param status of {@link rasterlab.exercises.child.Wire}
     * @throws IOException when the payload is not what the status promises
     */
    T read(int status, DataInputStream payload) throws IOException;
}
