package rasterlab.grader.storage

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test

class SecretsTest {
    @Test
    @DisplayName("one id or token of 64 begins with '-', which a command takes for an option")
    fun nothingThatIsTypedBeginsLikeAnOption() {
        val made = List(1_000) { Secrets.newId() } + List(1_000) { Secrets.newToken() }
        assertEquals(emptyList<String>(), made.filter { it.startsWith('-') })
        assertEquals(setOf(22, 43), made.map { it.length }.toSet())
    }
}
