package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.SQLException;

/** A PostgreSQL server that is killed, and back when it takes connections again. */
final class LostPostgres implements ServerFault {
    private static final String NAME = "lost";

    private final Path data;
    private final OwnPostgres postgres;

    /**
     * @param folder in which the data folder will be
     */
    LostPostgres(Path folder, OwnPostgres postgres) {
        data = folder.resolve("course");
        this.postgres = postgres;
    }

    @Override
    public Path data() {
        return data;
    }

    @Override
    public LabCall of(LabCall plain) {
        return plain.with("--db", postgres.address(NAME));
    }

    /** Makes the database that the server uses. */
    LostPostgres withDatabase() throws SQLException {
        postgres.create(NAME);
        return this;
    }

    @Override
    public String database() {
        return postgres.jdbc(NAME);
    }

    @Override
    public void begin(BenchServer server) {
        postgres.kill();
    }

    @Override
    public void end() throws IOException, InterruptedException {
        postgres.start();
    }
}
