package rasterlab.grader.postgres

import org.junit.jupiter.api.extension.AfterAllCallback
import org.junit.jupiter.api.extension.BeforeAllCallback
import org.junit.jupiter.api.extension.ExtendWith
import org.junit.jupiter.api.extension.ExtensionContext
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.PostgresAddress
import java.nio.file.Path

/** Runs the tests of a class on databases of a PostgreSQL server instead of files. */
@Target(AnnotationTarget.CLASS)
@ExtendWith(PostgresForClass::class)
annotation class OnPostgres

/** The databases of tests: a file in a test's folder, or one of a PostgreSQL server that is named after the folder. */
object TestDatabases {
    internal var server: LocalPostgres? = null

    fun open(folder: Path): Database {
        val postgres = server ?: return Database.open(folder.resolve("test.db"))
        val name =
            folder
                .toString()
                .filter { it.isLetterOrDigit() }
                .takeLast(40)
                .lowercase()
        return Database.open(checkNotNull(PostgresAddress.of(postgres.address(name))), folder, null)
    }
}

/** One server for all classes of a run. */
internal class PostgresForClass :
    BeforeAllCallback,
    AfterAllCallback {
    override fun beforeAll(context: ExtensionContext) {
        val store = context.root.getStore(ExtensionContext.Namespace.create(PostgresForClass::class.java))
        TestDatabases.server = store.getOrComputeIfAbsent("server", { LocalPostgres() }, LocalPostgres::class.java)
    }

    override fun afterAll(context: ExtensionContext) {
        TestDatabases.server = null
    }
}
