package rasterlab.tests.grading;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;

/** The server's SQLite file, opened beside it as another program would. */
record CourseDatabase(Connection connection) implements AutoCloseable {

    /**
     * Where a submission stands.
     *
     * @param tries how often grading it was begun
     * @param results how often a result of it was recorded
     */
    record Standing(String state, int tries, int results) {}

    static CourseDatabase of(Path data) throws SQLException {
        var file = data.resolve("rasterlab.db");
        return new CourseDatabase(DriverManager.getConnection("jdbc:sqlite:" + file));
    }

    /** Lets nobody else write until this is closed; reading goes on. */
    void hold() throws SQLException {
        try (var statement = connection.createStatement()) {
            statement.execute("PRAGMA busy_timeout = 5000");
            statement.execute("BEGIN IMMEDIATE");
        }
    }

    Standing standing(String submission) throws SQLException {
        var query =
                """
                SELECT state, tries, (SELECT count(*) FROM results WHERE submission_id = submissions.id)
                FROM submissions WHERE id = ?""";
        try (var statement = connection.prepareStatement(query)) {
            statement.setString(1, submission);
            try (var row = statement.executeQuery()) {
                if (!row.next()) throw new AssertionError("submission " + submission + " is lost");
                return new Standing(row.getString(1), row.getInt(2), row.getInt(3));
            }
        }
    }

    @Override
    public void close() throws SQLException {
        connection.close();
    }
}
