package rasterlab.tests.bench.grader;

import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;

/**
 * How many submissions a server's database has, by their results.
 *
 * @param ungraded those without a result
 * @param gradedOnce those with one
 * @param gradedMoreOften those with several
 */
record StoredCounts(int ungraded, int gradedOnce, int gradedMoreOften) {
    private static final String RESULTS =
            "SELECT count(r.submission_id) AS results FROM submissions s"
                    + " LEFT JOIN results r ON r.submission_id = s.id GROUP BY s.id";

    /** Reads them, beside the server that uses the database. */
    static StoredCounts in(String database) throws SQLException {
        String counts =
                "SELECT count(CASE WHEN results = 0 THEN 1 END),"
                        + " count(CASE WHEN results = 1 THEN 1 END),"
                        + " count(CASE WHEN results > 1 THEN 1 END) FROM ("
                        + RESULTS
                        + ") AS each_one";
        try (Connection connection = DriverManager.getConnection(database);
                Statement statement = connection.createStatement();
                ResultSet row = statement.executeQuery(counts)) {
            row.next();
            return new StoredCounts(row.getInt(1), row.getInt(2), row.getInt(3));
        }
    }

    int graded() {
        return gradedOnce + gradedMoreOften;
    }

    int submissions() {
        return ungraded + graded();
    }
}
