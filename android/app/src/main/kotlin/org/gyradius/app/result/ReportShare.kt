package org.gyradius.app.result

import android.content.ClipData
import android.content.Context
import android.content.Intent
import android.net.Uri
import android.print.PrintAttributes
import android.print.PrintManager
import android.webkit.WebView
import android.webkit.WebViewClient
import androidx.core.content.FileProvider
import java.io.File
import org.gyradius.app.R

/** Offers a report to the apps that take one. */
fun shareReport(context: Context, report: File) {
    val uri = FileProvider.getUriForFile(context, "${context.packageName}.files", report)
    context.startActivity(Intent.createChooser(shareIntent(uri), context.getString(R.string.report_share)))
}

/** Read by whoever is chosen, and by nobody else. */
internal fun shareIntent(uri: Uri): Intent = Intent(Intent.ACTION_SEND).apply {
    type = "text/html"
    putExtra(Intent.EXTRA_STREAM, uri)
    clipData = ClipData.newRawUri(null, uri)
    addFlags(Intent.FLAG_GRANT_READ_URI_PERMISSION)
}

/** Prints a report, or saves it as PDF: Android asks which. The web view must live until the page is laid out. */
fun printReport(context: Context, report: File) {
    val name = context.getString(R.string.report)
    WebView(context).apply {
        webViewClient = object : WebViewClient() {
            override fun onPageFinished(view: WebView, url: String) {
                val printer = context.getSystemService(PrintManager::class.java) ?: return
                printer.print(name, view.createPrintDocumentAdapter(name), PrintAttributes.Builder().build())
            }
        }
        loadDataWithBaseURL(null, report.readText(), "text/html", "utf-8", null)
    }
}
