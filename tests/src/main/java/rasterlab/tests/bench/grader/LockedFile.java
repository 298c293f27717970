package rasterlab.tests.bench.grader;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;

/** A database whose lock of writers another program has, such as a backup. */
final class LockedFile implements ServerFault, AutoCloseable {
    private static final int PATIENCE_MILLIS = 30_000;

    private final Path data;
    private Connection other;

    /**
     * @param folder in which the data folder will be
     */
    LockedFile(Path folder) {
        data = folder.resolve("course");
    }

    @Override
    public Path data() {
        return data;
    }

    @Override
    public void begin(BenchServer server) throws SQLException {
        other = DriverManager.getConnection(database());
        execute("PRAGMA busy_timeout = " + PATIENCE_MILLIS);
        execute("BEGIN IMMEDIATE");
    }

    @Override
    public void end() throws SQLException {
        execute("ROLLBACK");
    }

    private void execute(String sql) throws SQLException {
        try (Statement statement = other.createStatement()) {
            statement.execute(sql);
        }
    }

    @Override
    public void close() throws SQLException {
        if (other != null) other.close();
    }
}
