package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.SQLException;

/** A fault of the machine that comes while a server grades, and goes again. */
interface ServerFault {
    /** The folder of the server that it comes to, which is made by that. */
    Path data();

    /** The call of that server. */
    default LabCall of(LabCall plain) {
        return plain;
    }

    /** The address of its database for JDBC. */
    default String database() {
        return "jdbc:sqlite:" + data().resolve("rasterlab.db");
    }

    /**
     * Comes; returns when it is there.
     *
     * @throws NotMeasured where it does not reach the server on this machine
     */
    void begin(BenchServer server)
            throws IOException, InterruptedException, SQLException, NotMeasured;

    /** Goes; returns when its cause has gone. */
    void end() throws IOException, InterruptedException, SQLException;
}
