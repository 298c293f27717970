package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.scene.obj.ReadingRules;
import rasterlab.tests.Repository;

class ReadingRulesTest {
    @Test
    @DisplayName("README says other rules of models than the reader keeps")
    void readmeHasTheReadersTable() {
        String readme = Repository.text(Repository.root().resolve("README.md"));
        String table = String.join("\n", ReadingRules.table());
        assertTrue(readme.contains(table), "the table should be:\n" + table);
    }
}
