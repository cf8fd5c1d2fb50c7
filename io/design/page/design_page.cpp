// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/page/design_page.hpp"

#include "io/design/page/design_parts.hpp"
#include "io/pictures/view/page.hpp"
#include "io/pictures/view/page_parts.hpp"

namespace netloft::design {

namespace {

/// The body of the page, with the viewer at the marked place.
std::string body_with_viewer() {
  const std::string mark = "VIEWER\n";
  std::string body = kDesignBody;
  return body.replace(body.find(mark), mark.size(), pictures::kPageBody);
}

}  // namespace

std::string design_policy(const std::string& nonce) {
  return "default-src 'none'; script-src 'nonce-" + nonce + "'; style-src 'nonce-" + nonce +
         "'; img-src data: blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors "
         "'none'";
}

std::string design_page(const std::string& nonce) {
  const std::string script = "<script nonce=\"" + nonce + "\">";
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\">\n<title>Netloft design</title>\n<style nonce=\"" +
         nonce + "\">" + pictures::kPageStyle + kDesignStyle + "</style>\n</head>\n<body>\n" +
         body_with_viewer() + script + pictures::kPageLibraries + "</script>\n" + script +
         pictures::viewer_script(kDesignScripts) + "</script>\n</body>\n</html>\n";
}

}  // namespace netloft::design
