package rasterlab.grader.storage

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import org.postgresql.ds.PGSimpleDataSource

class PostgresAddressTest {
    @Test
    @DisplayName("a part of the address goes to another place, or the password stands in its text")
    fun readsEachPart() {
        val address =
            checkNotNull(PostgresAddress.of("postgresql://a%40b:p%3Aw+@db.example:6543/course?sslmode=require"))
        val source = address.source(patienceSeconds = 7) as PGSimpleDataSource
        assertEquals(listOf("a@b", "p:w+", "course"), listOf(source.user, source.password, source.databaseName))
        assertEquals("db.example" to 6543, source.serverNames.single() to source.portNumbers.single())
        assertEquals("require" to 7, source.sslMode to source.socketTimeout)
        assertEquals("postgresql://a@b@db.example:6543/course", "$address")
    }

    @Test
    @DisplayName("the password of the environment counts more than that of the address, or the usual port is asked for")
    fun fillsInWhatIsLeftOut() {
        val environment = mapOf("PGPASSWORD" to "secret")
        val passwords =
            listOf("postgres://u@h/n", "jdbc:postgresql://u:own@h/n").map {
                val source = checkNotNull(PostgresAddress.of(it, environment)).source(0) as PGSimpleDataSource
                assertEquals(5432, source.portNumbers.single())
                source.password
            }
        assertEquals(listOf("secret", "own"), passwords)
    }

    @ParameterizedTest(name = "{0} is taken, or its password is told")
    @ValueSource(
        strings = [
            "postgresql://u:hush@h", "postgresql://u:hush@h/", "postgresql://u:hush@h/a/b", "postgresql://u:hush@h:x/n",
            "postgresql://:hush@h/n", "postgresql://u:hush@h/n?user=other", "postgresql://u:hu sh@h/n", "postgresql:n",
            "postgresql://h/n",
        ],
    )
    fun refusesWhatSaysTooLittleOrTooMuch(url: String) {
        val message = assertThrows(CannotStart::class.java) { PostgresAddress.of(url) }.message
        assertTrue("expected postgresql://USER@HOST:PORT/NAME" in message, message)
        assertFalse("hush" in message || "hu sh" in message, message)
    }

    @Test
    fun leavesOtherDatabasesToOthers() = assertNull(PostgresAddress.of("sqlite:postgresql"))
}
